// SPDX-License-Identifier: BSD-3-Clause
// Registration of the observer `ros1_publisher` in a build without ROS.
#include "without_ros.hpp"

#include "publisher_parameters.hpp"
#include "tolman/plugin.hpp"

using ObserverWithoutRos =
    tolman::source_parameters::ObserverWithoutRos<tolman::ros1_publisher::PublisherParameters, 1>;

TOLMAN_PLUGIN(ros1_publisher, ObserverWithoutRos, "0.1.0",
              "Publishes pose, path, transform and map as topics of ROS 1.");
