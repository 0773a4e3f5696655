// SPDX-License-Identifier: BSD-3-Clause
// Registration of the observer that writes bags.
#include "tolman/plugin.hpp"

#include "bag_writer.hpp"

TOLMAN_PLUGIN(bag_writer, tolman::bag_writer::BagWriter, "0.1.0",
              "Writes images, calibration, truth and poses as a bag of ROS 2 or ROS 1.");
