// SPDX-License-Identifier: BSD-3-Clause
// The predicted motion over frames at which odometry failed.
//
// An odometry that failed before it stored a frame answers its next motion from the last frame that
// it answered; its `dt` shows that. The trajectory then contains the prediction already, so the
// prediction is removed from that motion and from later revisions of it. Prediction and remaining
// motion together are the motion that odometry measured.
#pragma once

#include <map>

#include "tolman/records.hpp"

namespace tolman::pipeline {

class PredictedWay {
 public:
  /// Odometry failed at a frame that it was given; `prediction` replaces its answer.
  void add(const Motion& prediction);
  /// Odometry answered. Removes the predictions from a motion that spans them.
  void takeOut(Motion& motion);
  /// The same for a revision of such a motion.
  void takeOut(MotionRevision& revision) const;

 private:
  Eigen::Isometry3d T_answered_given_ = Eigen::Isometry3d::Identity();  ///< predicted
  bool predicted_ = false;                                              ///< since the last answer
  std::int64_t given_ns_ = 0;                                           ///< of the last frame
  std::int64_t answered_ns_ = 0;                                        ///< of the last answer
  /// Removed predictions by the frame of the motion that spanned them.
  std::map<std::int64_t, Eigen::Isometry3d> taken_out_;
};

}  // namespace tolman::pipeline
