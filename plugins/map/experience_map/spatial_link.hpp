// SPDX-License-Identifier: BSD-3-Clause
// Residual of a link between two poses in space and its derivatives.
#pragma once

#include "pose_link.hpp"

namespace tolman::experience_map {

/// r = log((T_i e_ij)^-1 T_j): the motion from where the link expects `to` to where it is, as a
/// twist (m, rad) in the tangent space in which the covariance is given. It does not depend on the
/// world frame.
Vector6d residualOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                    const Eigen::Isometry3d& to);

/// dr/d_to = J(r), dr/d_from = -J(r) Ad(T_j^-1 T_i), J: the inverse right Jacobian of SE(3).
LinkDerivatives<Space> derivativesOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                                     const Eigen::Isometry3d& to);

/// a followed by b, the counterpart of compose() for planar poses.
inline Eigen::Isometry3d compose(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return a * b;
}
inline Eigen::Isometry3d between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return a.inverse() * b;
}

/// T * expSe3(step).
Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6d& step);

}  // namespace tolman::experience_map
