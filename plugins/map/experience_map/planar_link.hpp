// SPDX-License-Identifier: BSD-3-Clause
// The paper's residual of one link between two planar nodes.
#pragma once

#include <cstddef>
#include <tolman/geometry.hpp>

namespace tolman::experience_map {

struct PlanarLink {
  std::size_t from = 0;
  std::size_t to = 0;
  PlanarPose pose;             ///< of `to`, seen from `from`
  Eigen::Matrix3d covariance;  ///< along the axes of `from`
  bool robust = true;          ///< may lose weight; otherwise plain least squares
  double weight = 1;           ///< what the loss leaves of its influence, in [0, 1]
};

/// f(e_i, e_j, e_ij) of the paper's section Cognitive Map,
///
///   x_j - x_i - d cos(theta_i + heading)
///   y_j - y_i - d sin(theta_i + heading)
///   theta_j - theta_i - facing            (wrapped)
///
/// turned by -theta_i, so that it is seen along the axes of e_i in which the covariance is known.
/// Where the noise is isotropic the turn does not change its length. The link's pose is e_j seen
/// from e_i: d and heading are its polar form, facing its theta.
Eigen::Vector3d residualOf(const PlanarLink& link, const PlanarPose& from, const PlanarPose& to);

/// Its derivatives by (x, y, theta) of both ends.
struct LinkDerivatives {
  Eigen::Matrix3d by_from;
  Eigen::Matrix3d by_to;
};
LinkDerivatives derivativesOf(const PlanarPose& from, const PlanarPose& to);

/// Inverse of a covariance. Standard deviations below 1e-6 count as about 1e-6, so that a
/// degenerate covariance cannot divide by zero.
Eigen::Matrix3d informationOf(const Eigen::Matrix3d& covariance);

}  // namespace tolman::experience_map
