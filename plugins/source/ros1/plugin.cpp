// SPDX-License-Identifier: BSD-3-Clause
// Registration of the source of live images of ROS 1.
#include "tolman/plugin.hpp"

#include "ros1_source.hpp"

TOLMAN_PLUGIN(ros1, tolman::ros1::Ros1Source, "0.1.0",
              "Images of one camera or a pair, live from topics of ROS 1.");
