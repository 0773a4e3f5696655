// SPDX-License-Identifier: BSD-3-Clause
// The steady errors of odometry as unknowns b of the map, next to the poses (path_calibration).
// They correct every odometry link alike.
#pragma once

#include <path_calibration.hpp>
#include <vector>

#include "pose_link.hpp"

namespace tolman::experience_map {

template <class G>
inline constexpr int kErrors = G::kSize == 3 ? kPlanarErrors : kSpatialErrors;
template <class G>
using ErrorsOf = Eigen::Matrix<double, kErrors<G>, 1>;
template <class G>
using EffectOf = Eigen::Matrix<double, G::kSize, kErrors<G>>;

inline PlanarPose corrected(const PlanarPose& reported, const Eigen::Vector3d& by) {
  return {reported.x + by.x(), reported.y + by.y(), wrapAngle(reported.theta + by.z())};
}
inline Eigen::Isometry3d corrected(const Eigen::Isometry3d& reported, const Vector6d& by) {
  return reported * expSe3(by);
}

/// Derivative of a corrected link's residual with respect to b. In space a motion of the link's end
/// equals the opposite one of its beginning, seen through the link.
inline EffectOf<Plane> byErrors(const EffectOf<Plane>& effect, const PlanarLink&,
                                const LinkDerivatives<Plane>&) {
  return -effect;
}
inline EffectOf<Space> byErrors(const EffectOf<Space>& effect, const SpatialLink& link,
                                const LinkDerivatives<Space>& derivatives) {
  return derivatives.by_from * (adjointSe3(link.pose) * effect);
}

template <class G>
struct SteadyErrors {
  std::vector<typename G::Pose> reported = {};  ///< of each odometry link, uncorrected
  std::vector<EffectOf<G>> effects = {};        ///< of each odometry link, along its covariance
  ErrorsOf<G> b = ErrorsOf<G>::Zero();
  ErrorsOf<G> precision = ErrorsOf<G>::Ones();  ///< of the prior of each error, whose mean is 0

  /// Energy of the prior.
  double energy() const { return effects.empty() ? 0 : b.dot(precision.cwiseProduct(b)); }
  /// Sets the poses of the odometry links, which are the first of `links`.
  void correct(std::vector<PoseLink<G>>& links) const {
    for (std::size_t k = 0; k < effects.size(); ++k) {
      links[k].pose = corrected(reported[k], effects[k] * b);
    }
  }
};

}  // namespace tolman::experience_map
