// SPDX-License-Identifier: BSD-3-Clause
// Dead reckoning: the poses that follow from composing the latest motions of odometry,
//
//   T_start_k = T_start_(k-1) * T_(k-1)_k        (metres; the first frame is the origin)
//
// with the covariance between any two frames. A revision of a motion changes all later poses.
// Frames are addressed by slot, their position in the order of arrival.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tolman/records.hpp>

#include "growing_list.hpp"
#include "parameters.hpp"
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

struct ReckonedFrame {
  std::int64_t frame = -1;
  std::int64_t stamp_ns = 0;
  Eigen::Isometry3d T_start_camera = Eigen::Isometry3d::Identity();  ///< dead reckoning
  std::int64_t anchor = 0;                                           ///< see ExperienceChain
  bool initialising = false;  ///< its motion is in state Initialising
  bool gap = false;           ///< the motion to this frame is unknown
};

class DeadReckoning {
 public:
  explicit DeadReckoning(const Parameters& parameters = {}) : parameters_(parameters) {}

  /// InvalidInput if `motion` cannot come after the motions that were appended so far.
  Status check(const Motion& motion) const;
  /// A motion in state Initialising after one in another state is a gap: tracking restarted at an
  /// unknown pose.
  void append(const Motion& motion, std::int64_t anchor);
  /// Replaces motions; of several revisions of one frame the last is used. Returns the first slot
  /// whose pose changed, size() if none did. `unknown` counts revisions of frames that were never
  /// appended.
  std::size_t revise(std::span<const MotionRevision> revisions, std::size_t& unknown);

  std::optional<std::size_t> slotOf(std::int64_t frame) const;
  /// Motion from one slot to a later one, with its covariance.
  PathMotion between(std::size_t from, std::size_t to) const;
  double seconds(std::size_t from, std::size_t to) const;

  const ReckonedFrame& operator[](std::size_t slot) const { return frames_[slot]; }
  /// Motion from the previous slot; the identity at slot 0.
  const UncertainPose& motionTo(std::size_t slot) const { return motions_[slot]; }
  void moveTo(std::size_t slot, std::int64_t anchor) { frames_[slot].anchor = anchor; }
  std::size_t size() const { return frames_.size(); }
  std::size_t last() const { return frames_.size() - 1; }
  /// Whether all motions so far were in the plane of the first camera, as recorded planar motion
  /// is.
  bool isPlanar() const { return planar_; }
  /// Whether the scale of all motions so far was known.
  bool isMetric() const { return metric_; }
  void setMetric(bool metric) { metric_ = metric; }
  /// Appends the next frame of a saved state; T_start_camera is recomputed.
  void restore(ReckonedFrame frame, const UncertainPose& motion);

 private:
  void reckon(std::size_t first);

  Parameters parameters_;
  GrowingList<ReckonedFrame> frames_;
  GrowingList<UncertainPose> motions_;  ///< from the previous frame
  bool planar_ = true;
  bool metric_ = true;
};

}  // namespace tolman::experience_map
