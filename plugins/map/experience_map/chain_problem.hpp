// SPDX-License-Identifier: BSD-3-Clause
// The optimiser's problem in a geometry G, and the conversion of the map's poses to those of G.
#pragma once

#include "graph_optimiser.hpp"
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

template <class G>
typename G::Pose poseIn(const Eigen::Isometry3d& T_world_camera);
template <>
inline PlanarPose poseIn<Plane>(const Eigen::Isometry3d& T_world_camera) {
  return toPlanar(T_world_camera);
}
template <>
inline Eigen::Isometry3d poseIn<Space>(const Eigen::Isometry3d& T_world_camera) {
  return T_world_camera;
}

inline Eigen::Isometry3d lifted(const PlanarPose& pose) { return fromPlanar(pose); }
inline Eigen::Isometry3d lifted(const Eigen::Isometry3d& pose) { return normalised(pose); }

/// The matrix by which a small motion of the end of T_start_to, in the tangent space there, becomes
/// one of the end of its link, along the link's covariance.
template <class G>
Eigen::Matrix<double, G::kSize, 6> endProjection(const Eigen::Isometry3d& T_start_from,
                                                 const Eigen::Isometry3d& T_start_to);
template <>
inline Eigen::Matrix<double, 3, 6> endProjection<Plane>(const Eigen::Isometry3d& T_start_from,
                                                        const Eigen::Isometry3d& T_start_to) {
  return planarProjection(T_start_to.linear(), toPlanar(T_start_from).theta);
}
template <>
inline Matrix6d endProjection<Space>(const Eigen::Isometry3d&, const Eigen::Isometry3d&) {
  return Matrix6d::Identity();
}

/// The pose and covariance of the link that stands for a motion from T_start_from. In the plane the
/// motion is projected to the x-z plane of the first camera, not to that of the tilted camera at
/// its beginning, so that the residuals of dead reckoning are zero.
template <class G>
PoseLink<G> linkOf(const Eigen::Isometry3d& T_start_from, const UncertainPose& motion);
template <>
inline PlanarLink linkOf<Plane>(const Eigen::Isometry3d& T_start_from,
                                const UncertainPose& motion) {
  const Eigen::Isometry3d T_start_to = T_start_from * motion.T;
  const Eigen::Matrix<double, 3, 6> project = endProjection<Plane>(T_start_from, T_start_to);
  PlanarLink link;
  link.pose = between(toPlanar(T_start_from), toPlanar(T_start_to));
  link.covariance = project * motion.covariance * project.transpose();
  return link;
}
template <>
inline SpatialLink linkOf<Space>(const Eigen::Isometry3d&, const UncertainPose& motion) {
  SpatialLink link;
  link.pose = motion.T;
  link.covariance = 0.5 * (motion.covariance + motion.covariance.transpose());
  return link;
}

}  // namespace tolman::experience_map
