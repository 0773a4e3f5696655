// SPDX-License-Identifier: BSD-3-Clause
// The optimiser's problem in a geometry G, and the conversion of the map's poses to those of G.
#pragma once

#include <vector>

#include "planar_link.hpp"
#include "spatial_link.hpp"
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

template <class G>
struct ChainProblem {
  std::vector<typename G::Pose> reckoned;  ///< poses of the anchors by dead reckoning
  std::vector<typename G::Pose> nodes;
  std::vector<PoseLink<G>> links;  ///< odometry links, then loop links
};

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

/// The pose and covariance of the link that stands for a motion from T_start_from. In the plane the
/// motion is projected to the x-z plane of the first camera, not to that of the tilted camera at
/// its beginning, so that the residuals of dead reckoning are zero.
template <class G>
PoseLink<G> linkOf(const Eigen::Isometry3d& T_start_from, const UncertainPose& motion);
template <>
inline PlanarLink linkOf<Plane>(const Eigen::Isometry3d& T_start_from,
                                const UncertainPose& motion) {
  const PlanarPose from = toPlanar(T_start_from);
  const Eigen::Isometry3d T_start_to = T_start_from * motion.T;
  PlanarLink link;
  link.pose = between(from, toPlanar(T_start_to));
  link.covariance = planarCovariance(motion.covariance, T_start_to.linear(), from.theta);
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
