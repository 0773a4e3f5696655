// SPDX-License-Identifier: BSD-3-Clause
// What was answered for the recent frames, hung on their keyframes, and what is owed since.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "tolman/records.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

/// Poses of frames relative to keyframes of the window. When the window moves its keyframes the
/// frames move along, and motions that were answered before become revisions. Holds no more than
/// the frames of the window, and of these no more than the last kMost: a camera that stands makes
/// no keyframes.
class Trajectory {
 public:
  static constexpr std::size_t kMost = 500;

  void clear() { entries_.clear(); }
  bool empty() const { return entries_.empty(); }

  /// The latest frame, at T_world_camera, riding on `keyframe`; returns its motion from the frame
  /// added before, which counts as answered with this covariance.
  Eigen::Isometry3d add(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                        const Keyframe& keyframe, const Matrix6d& covariance);
  /// The last frame's motion was answered as the identity: nothing was known yet.
  void answeredNothing() { entries_.back().answered.setIdentity(); }
  const Eigen::Isometry3d& lastPose() const { return entries_.back().T_world_camera; }

  /// Moves the frames along with their keyframes.
  void follow(const Window& window);
  /// Spreads the frames after `first_lost` - 1 evenly up to T_world_current, `steps` frames from
  /// there to the current one: what the frames without sight most likely did.
  void bridge(std::int64_t first_lost, const Eigen::Isometry3d& T_world_current);

  /// Motions that changed by more than a millimetre or a hundredth of a milliradian.
  std::vector<MotionRevision> revisions();
  /// Every motion that changed at all, of frames that no keyframe of `window` carries; forgets
  /// them.
  std::vector<MotionRevision> retire(const Window& window);
  /// Every motion that changed at all.
  std::vector<MotionRevision> finish() { return collect(0, 0, entries_.size()); }

 private:
  struct Entry {
    std::int64_t frame = -1;
    std::int64_t keyframe = -1;
    Eigen::Isometry3d T_keyframe_camera = Eigen::Isometry3d::Identity();
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
    Eigen::Isometry3d answered = Eigen::Isometry3d::Identity();  ///< motion from the frame before
    Matrix6d covariance = Matrix6d::Zero();
  };
  std::vector<MotionRevision> collect(double metres, double radians, std::size_t end);

  std::deque<Entry> entries_;  ///< oldest first; the first one's motion is final
};

}  // namespace tolman::direct_sparse
