// SPDX-License-Identifier: BSD-3-Clause
// Which topics of a bag are the cameras and the other sensors of the run.
#pragma once

#include <map>
#include <string>

#include "bag.hpp"
#include "bag_parameters.hpp"

namespace tolman::ros_bag {

/// Topics of a run; null for those that there are not.
struct ChosenTopics {
  const BagTopic* left = nullptr;
  const BagTopic* right = nullptr;
  const BagTopic* left_info = nullptr;
  const BagTopic* right_info = nullptr;
  const BagTopic* depth = nullptr;
  const BagTopic* imu = nullptr;
  const BagTopic* odometry = nullptr;
};

/// Those that the parameters name, and for the others what is the only possibility. A topic that is
/// not there, is of another type, or is not the only possibility is InvalidParameter: the message
/// names the parameter to set and the topics to choose from.
Result<ChosenTopics> chooseTopics(const std::map<std::string, BagTopic>& topics,
                                  const BagParameters& parameters);

/// Whether the second name is that of the right camera where the first is that of the left one:
/// they differ in "left" and "right", or in one digit by one.
bool isPair(const std::string& left, const std::string& right);

}  // namespace tolman::ros_bag
