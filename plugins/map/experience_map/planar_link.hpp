// SPDX-License-Identifier: BSD-3-Clause
// Residual of a link between two planar poses (paper, section "Cognitive Map") and its derivatives.
// Lengths are metres, angles radians.
#pragma once

#include "pose_link.hpp"

namespace tolman::experience_map {

/// f(e_i, e_j, e_ij) of the paper's section Cognitive Map,
///
///   x_j - x_i - d cos(theta_i + heading)
///   y_j - y_i - d sin(theta_i + heading)
///   theta_j - theta_i - facing            (wrapped)
///
/// rotated by -theta_i into the axes of e_i, in which the covariance is given. If the noise is
/// isotropic, this rotation does not change the length of the residual. The link's pose is that of
/// e_j relative to e_i: d and heading are its polar form, facing is its theta.
Eigen::Vector3d residualOf(const PlanarLink& link, const PlanarPose& from, const PlanarPose& to);

/// Its derivatives with respect to (x, y, theta) of both ends.
LinkDerivatives<Plane> derivativesOf(const PlanarLink& link, const PlanarPose& from,
                                     const PlanarPose& to);

/// The pose after a step (m, m, rad).
PlanarPose moved(const PlanarPose& pose, const Eigen::Vector3d& step);

}  // namespace tolman::experience_map
