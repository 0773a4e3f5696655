// SPDX-License-Identifier: BSD-3-Clause
// Every frame's motion as last said by odometry, and the path that follows from it by dead
// reckoning. Frames are addressed by slot: their rank among the frames seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tolman/records.hpp>
#include <vector>

#include "parameters.hpp"
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

struct LoggedFrame {
  std::int64_t frame = -1;
  std::int64_t stamp_ns = 0;
  UncertainPose motion;  ///< from the slot before; the identity at slot 0
  Eigen::Isometry3d T_start_camera = Eigen::Isometry3d::Identity();  ///< dead reckoning
  std::int64_t anchor = 0;                                           ///< see ExperienceChain
  bool initialising = false;                                         ///< odometry had no motion yet
  bool gap = false;  ///< how the robot came here is unknown
};

class MotionLog {
 public:
  explicit MotionLog(const Parameters& parameters = {}) : parameters_(parameters) {}

  /// What is wrong with the motion as the next one; ok when append() would take it.
  Status check(const Motion& motion) const;
  /// A motion that is Initialising, and the one before was not: odometry has begun anew, because
  /// the robot was switched on again or carried away. That is a gap.
  void append(const Motion& motion, std::int64_t anchor);
  /// Replaces motions and reckons anew from there; later revisions win. Returns the first slot
  /// whose pose changed, size() for none. Counts revisions of frames never seen in `unknown`.
  std::size_t revise(std::span<const MotionRevision> revisions, std::size_t& unknown);

  std::optional<std::size_t> slotOf(std::int64_t frame) const;
  /// Motion from one slot to a later one, with the covariance of the way between them.
  UncertainPose between(std::size_t from, std::size_t to) const;
  double seconds(std::size_t from, std::size_t to) const;

  const LoggedFrame& operator[](std::size_t slot) const { return frames_[slot]; }
  void moveTo(std::size_t slot, std::int64_t anchor) { frames_[slot].anchor = anchor; }
  std::size_t size() const { return frames_.size(); }
  std::size_t last() const { return frames_.size() - 1; }
  /// Takes frames of a saved log; T_start_camera is reckoned anew.
  void restore(std::vector<LoggedFrame> frames);

 private:
  void reckon(std::size_t first);

  Parameters parameters_;
  std::vector<LoggedFrame> frames_;
};

}  // namespace tolman::experience_map
