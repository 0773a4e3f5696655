// SPDX-License-Identifier: BSD-3-Clause
// Which published topics are the cameras of the run.
#pragma once

#include <map>
#include <string>

#include "live_parameters.hpp"
#include "tolman/status.hpp"

namespace tolman::live_images {

/// Names of topics; empty if there is none.
struct LiveTopics {
  std::string left;
  std::string right;
  std::string left_info;
  std::string right_info;
  std::string depth;
  std::string imu;
  std::string odometry;
};

/// Chooses the topics that the parameters name, and for the others the only possibility.
/// `published`: types by name; `command` lists them. InvalidInput if a topic is not published
/// (yet). InvalidParameter if there is more than one possibility; the message names the topics.
Result<LiveTopics> chooseLiveTopics(const std::map<std::string, std::string>& published,
                                    const LiveParameters& parameters, const std::string& command);

/// The type of the messages in the notation of ROS 2, of one in that of either.
std::string ros2Type(const std::string& type);

}  // namespace tolman::live_images
