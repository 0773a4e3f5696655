// SPDX-License-Identifier: BSD-3-Clause
// Registration of the observer that publishes to ROS 1.
#include "tolman/plugin.hpp"

#include "ros1_publisher.hpp"

TOLMAN_PLUGIN(ros1_publisher, tolman::ros1_publisher::Ros1Publisher, "0.1.0",
              "Publishes pose, path, transform and map as topics of ROS 1.");
