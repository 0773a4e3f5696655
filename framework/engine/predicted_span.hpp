// SPDX-License-Identifier: BSD-3-Clause
// The motion that was predicted for the frames at which odometry failed.
//
// An odometry that failed at a frame may return its next motion relative to the last frame that it
// answered; the `dt` of that motion spans both. The trajectory already contains the prediction for
// the frames between, so it is subtracted from that motion and from later revisions of it:
// prediction and remaining motion composed are the motion that odometry measured.
#pragma once

#include <map>

#include "tolman/records.hpp"

namespace tolman::pipeline {

class PredictedSpan {
 public:
  /// Odometry failed at a frame; `prediction` is recorded instead of its answer.
  void add(const Motion& prediction);
  /// Odometry answered with `motion`. Subtracts the predictions if it spans them.
  void subtractFrom(Motion& motion);
  /// The same for a revision of such a motion.
  void subtractFrom(MotionRevision& revision) const;

 private:
  Eigen::Isometry3d T_answered_given_ = Eigen::Isometry3d::Identity();  ///< predicted
  bool predicted_ = false;                                              ///< since the last answer
  std::int64_t given_ns_ = 0;                                           ///< of the last frame
  std::int64_t answered_ns_ = 0;                                        ///< of the last answer
  /// Removed predictions by the frame of the motion that spanned them.
  std::map<std::int64_t, Eigen::Isometry3d> subtracted_;
};

}  // namespace tolman::pipeline
