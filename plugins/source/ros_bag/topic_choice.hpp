// SPDX-License-Identifier: BSD-3-Clause
// Which topics of a bag are the cameras and the other sensors of the run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bag.hpp"
#include "bag_parameters.hpp"
#include "true_poses.hpp"

namespace tolman::ros_bag {

/// Topics of a run; null if there is none.
struct ChosenTopics {
  const BagTopic* left = nullptr;
  const BagTopic* right = nullptr;
  const BagTopic* left_info = nullptr;
  const BagTopic* right_info = nullptr;
  const BagTopic* depth = nullptr;
  const BagTopic* imu = nullptr;
  const BagTopic* odometry = nullptr;
  const BagTopic* truth = nullptr;
  std::vector<Finding> undecided;  ///< sensors with several topics, none of them chosen
};

/// Chooses the topics that the parameters name, and for the others the only possibility. A topic
/// that is missing, of another type or not the only possibility is InvalidParameter, unless it is
/// of a sensor beside the cameras (`undecided`); the message names the parameter to set and the
/// topics to choose from.
Result<ChosenTopics> chooseTopics(const std::map<std::string, BagTopic>& topics,
                                  const BagParameters& parameters);

}  // namespace tolman::ros_bag
