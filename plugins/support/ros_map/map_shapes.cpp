// SPDX-License-Identifier: BSD-3-Clause
#include "map_shapes.hpp"

namespace tolman::ros_map {
namespace {

/// Camera axes (x right, y down, z forward) in axes of ROS (x forward, y left, z up).
Eigen::Matrix3d cameraInRos() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return R;
}

RosPoint pointOf(const Eigen::Isometry3d& T_world_camera) {
  const Eigen::Vector3d t = cameraInRos() * T_world_camera.translation();
  return {t.x(), t.y(), t.z()};
}

RosPose poseOf(const Eigen::Isometry3d& T_world_camera, const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized();
  return {pointOf(T_world_camera), q.x(), q.y(), q.z(), q.w()};
}

}  // namespace

RosPose robotPose(const Eigen::Isometry3d& T_world_camera) {
  return poseOf(T_world_camera,
                cameraInRos() * T_world_camera.linear() * cameraInRos().transpose());
}

RosPose cameraPose(const Eigen::Isometry3d& T_world_camera) {
  return poseOf(T_world_camera, cameraInRos() * T_world_camera.linear());
}

MapShapes shapesOf(const MapGraph& graph) {
  MapShapes shapes;
  for (const Experience& experience : graph.experiences) {
    shapes.path.push_back(robotPose(experience.T_world_experience));
    shapes.experiences.push_back(shapes.path.back().position);
  }
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) continue;
    auto& lines = link.kind == LinkKind::Loop ? shapes.loops : shapes.odometry;
    lines.push_back(shapes.experiences[static_cast<std::size_t>(link.from)]);
    lines.push_back(shapes.experiences[static_cast<std::size_t>(link.to)]);
  }
  return shapes;
}

}  // namespace tolman::ros_map
