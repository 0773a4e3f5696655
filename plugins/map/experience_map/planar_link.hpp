// SPDX-License-Identifier: BSD-3-Clause
// Residual of a link between two planar poses (paper, section "Cognitive Map") and its derivatives.
// Lengths are metres, angles radians.
#pragma once

#include <cstddef>
#include <tolman/geometry.hpp>

namespace tolman::experience_map {

struct PlanarLink {
  std::size_t from = 0;
  std::size_t to = 0;
  PlanarPose pose;             ///< of `to`, relative to `from`
  Eigen::Matrix3d covariance;  ///< along the axes of `from`
  bool robust = true;          ///< under the robust loss; otherwise plain least squares
  double weight = 1;           ///< weight that the robust loss leaves it, in [0, 1]
};

/// f(e_i, e_j, e_ij) of the paper's section Cognitive Map,
///
///   x_j - x_i - d cos(theta_i + heading)
///   y_j - y_i - d sin(theta_i + heading)
///   theta_j - theta_i - facing            (wrapped)
///
/// rotated by -theta_i into the axes of e_i, in which the covariance is given. For isotropic noise
/// the rotation does not change its length. The link's pose is that of e_j relative to e_i: d and
/// heading are its polar form, facing is its theta.
Eigen::Vector3d residualOf(const PlanarLink& link, const PlanarPose& from, const PlanarPose& to);

/// Its derivatives by (x, y, theta) of both ends.
struct LinkDerivatives {
  Eigen::Matrix3d by_from;
  Eigen::Matrix3d by_to;
};
LinkDerivatives derivativesOf(const PlanarPose& from, const PlanarPose& to);

/// Inverse of a covariance. 1e-12 is added to the variances, so that a singular one has an inverse.
Eigen::Matrix3d informationOf(const Eigen::Matrix3d& covariance);

}  // namespace tolman::experience_map
