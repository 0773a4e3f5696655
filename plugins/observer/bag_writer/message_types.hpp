// SPDX-License-Identifier: BSD-3-Clause
// Definitions of messages, which bags carry so that any reader understands them.
#pragma once

#include <string>

#include "field_writer.hpp"

namespace tolman::bag_writer {

/// The fields of the type ("nav_msgs/msg/Odometry") and of all types in it.
std::string definitionOf(const std::string& type, ros_map::Format format);

/// By which ROS 1 tells versions of a type apart.
std::string sumOf(const std::string& type);

/// "nav_msgs/Odometry".
std::string ros1Type(const std::string& type);

}  // namespace tolman::bag_writer
