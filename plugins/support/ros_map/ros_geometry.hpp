// SPDX-License-Identifier: BSD-3-Clause
// Poses and shapes of a map in the axes of ROS, as plain numbers: this header is also compiled as
// C++17.
#pragma once

#include <vector>

namespace tolman::ros_map {

struct RosPoint {
  double x = 0, y = 0, z = 0;  ///< m
};

struct RosPose {
  RosPoint position;
  double qx = 0, qy = 0, qz = 0, qw = 1;
};

struct MapShapes {
  std::vector<RosPose> path;          ///< experiences in the order in which they were made
  std::vector<RosPoint> experiences;  ///< their places
  std::vector<RosPoint> odometry;     ///< two points for each link
  std::vector<RosPoint> loops;        ///< two points for each link that was not rejected
};

}  // namespace tolman::ros_map
