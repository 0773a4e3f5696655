// SPDX-License-Identifier: BSD-3-Clause
// Registration of the source of live images of ROS 2.
#include "tolman/plugin.hpp"

#include "ros2_source.hpp"

TOLMAN_PLUGIN(ros2, tolman::ros2::Ros2Source, "0.1.0",
              "Images of one camera or a pair, live from topics of ROS 2.");
