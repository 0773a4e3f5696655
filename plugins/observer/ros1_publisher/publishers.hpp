// SPDX-License-Identifier: BSD-3-Clause
// The topics of the observer. Debian's message headers of ROS 1 do not compile as C++20, so the
// file that includes them is compiled as C++17, and this header includes nothing of the SDK.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <string>

#include "ros_geometry.hpp"

namespace tolman::ros1_publisher {

using ros_map::MapShapes;
using ros_map::RosPoint;
using ros_map::RosPose;

class Publishers {
 public:
  /// Topics below `prefix`, and /tf if `tf`. Path and map are latched: a later subscriber gets the
  /// last ones.
  Publishers(ros::NodeHandle& node, const std::string& prefix, const std::string& map_frame,
             const std::string& camera_frame, bool tf);

  void publishPose(std::int64_t stamp_ns, const RosPose& robot, const RosPose& camera);
  void publishMap(std::int64_t stamp_ns, const MapShapes& shapes);

 private:
  std::string map_frame_;
  std::string camera_frame_;
  bool has_tf_;
  ros::Publisher pose_, path_, map_, tf_;
};

}  // namespace tolman::ros1_publisher
