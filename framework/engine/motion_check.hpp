// SPDX-License-Identifier: BSD-3-Clause
// Whether the motions of odometry are possible for the robot: speed, change of speed, turn rate.
#pragma once

#include <optional>
#include <string>

#include "config/settings.hpp"
#include "tolman/records.hpp"

namespace tolman::pipeline {

class MotionCheck {
 public:
  explicit MotionCheck(const config::CheckSettings& settings) : settings_(settings) {}

  /// Call it with each motion, in order. Returns why a motion in state Tracking is impossible; none
  /// if it is possible. If the scale is unknown, only the turn rate is checked.
  std::optional<std::string> check(const Motion& motion);
  /// The same for a revision of an earlier motion over `dt` s. Only speed and turn rate are
  /// checked, because neighbouring motions may be revised as well.
  std::optional<std::string> checkRevision(const MotionRevision& revision, double dt,
                                           bool scale_known) const;

 private:
  std::optional<std::string> tooFast(const Eigen::Isometry3d& moved, double dt,
                                     bool scale_known) const;
  std::optional<std::string> reasonAgainst(const Motion& motion, double speed) const;

  config::CheckSettings settings_;
  std::optional<double> speed_;  ///< of the last possible motion, m/s
  double since_ = 0;             ///< s since that motion
};

}  // namespace tolman::pipeline
