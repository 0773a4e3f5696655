// SPDX-License-Identifier: BSD-3-Clause
// Registration of the source of ROS 2 bags.
#include "tolman/plugin.hpp"

#include "bag_source.hpp"

TOLMAN_PLUGIN(
    ros_bag, tolman::ros_bag::BagSource, "0.1.0",
    "A bag of ROS 2 (.mcap, .db3) or ROS 1 (.bag): images, calibration, inertial measurements, "
    "odometry.");
