// SPDX-License-Identifier: BSD-3-Clause
// Registration of the source `ros2` in a build without DDS.
#include "without_ros.hpp"

#include "ros2_parameters.hpp"
#include "tolman/plugin.hpp"

using SourceWithoutRos =
    tolman::source_parameters::SourceWithoutRos<tolman::ros2::Ros2Parameters, 2>;

TOLMAN_PLUGIN(ros2, SourceWithoutRos, "0.1.0",
              "Images of one camera or a pair, live from topics of ROS 2.");
