// SPDX-License-Identifier: BSD-3-Clause
// Registration of the observer `ros2_publisher` in a build without DDS.
#include "without_ros.hpp"

#include "publisher_parameters.hpp"
#include "tolman/plugin.hpp"

using ObserverWithoutRos =
    tolman::source_parameters::ObserverWithoutRos<tolman::ros2_publisher::PublisherParameters, 2>;

TOLMAN_PLUGIN(ros2_publisher, ObserverWithoutRos, "0.1.0",
              "Publishes odometry, transforms, map and state as topics of ROS 2.");
