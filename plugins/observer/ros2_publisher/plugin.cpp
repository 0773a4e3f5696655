// SPDX-License-Identifier: BSD-3-Clause
// Registration of the observer that publishes to ROS 2.
#include "tolman/plugin.hpp"

#include "ros2_publisher.hpp"

TOLMAN_PLUGIN(ros2_publisher, tolman::ros2_publisher::Ros2Publisher, "0.1.0",
              "Publishes odometry, transforms, map and state as topics of ROS 2.");
