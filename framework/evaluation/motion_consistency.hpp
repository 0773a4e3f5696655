// SPDX-License-Identifier: BSD-3-Clause
// Whether the covariances that an odometry reports fit its errors: the normalised estimation error
// squared (Bar-Shalom, Li, Kirubarajan, "Estimation with applications to tracking and navigation",
// 2001, section 5.4): `nees` of metrics.json.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

struct MotionConsistency {
  std::size_t motions = 0;             ///< tracked motions in metres, with truth at both ends
  std::size_t without_covariance = 0;  ///< of those: the covariance is not positive definite
  double mean = 0;             ///< mean of the others; degrees_of_freedom for correct covariances
  double share_99 = 0;         ///< share of `motions` within the ellipsoid that should contain 99 %
  int degrees_of_freedom = 6;  ///< 3 for an estimate in the plane
};

/// Compares motions with the truth, one at a time in the order of frames.
class MotionErrors {
 public:
  /// `planar`: only the motion in the plane counts (camera x, z and the turn about y).
  MotionErrors(const Trajectory& truth, bool planar);
  /// `motion` is since the motion that was added before.
  void add(const Motion& motion);
  MotionConsistency result() const;

 private:
  const Trajectory& truth_;
  bool planar_;
  Trajectory::const_iterator next_;
  const TrajectoryPose* before_ = nullptr;  ///< truth at the motion before; null for none
  MotionConsistency sums_;                  ///< `mean` and `share_99` not yet divided
};

/// Null numbers, with the cause in `reason`, where no motion could be compared.
nlohmann::ordered_json toJson(const MotionConsistency& consistency);

}  // namespace tolman::evaluation
