// SPDX-License-Identifier: BSD-3-Clause
// The host's poses and maps in the axes of ROS: x forward, y left and z up at the first image. The
// host's world is that of a camera: x right, y down, z forward.
#pragma once

#include <Eigen/Geometry>

#include "ros_geometry.hpp"
#include "tolman/records.hpp"

namespace tolman::ros_map {

/// Axes of the robot (x forward) in the map, as RViz shows poses.
RosPose robotPose(const Eigen::Isometry3d& T_world_camera);

/// The camera's own axes (z along the optical axis) in the map, for tf.
RosPose cameraPose(const Eigen::Isometry3d& T_world_camera);

MapShapes shapesOf(const MapGraph& graph);

}  // namespace tolman::ros_map
