// SPDX-License-Identifier: BSD-3-Clause
// Registration of the source `ros1` in a build without ROS.
#include "without_ros.hpp"

#include "ros1_parameters.hpp"
#include "tolman/plugin.hpp"

using SourceWithoutRos =
    tolman::source_parameters::SourceWithoutRos<tolman::ros1::Ros1Parameters, 1>;

TOLMAN_PLUGIN(ros1, SourceWithoutRos, "0.1.0",
              "Images of one camera or a pair, live from topics of ROS 1.");
