// SPDX-License-Identifier: BSD-3-Clause
// A topic of a bag.
#pragma once

#include <string>
#include <string_view>

namespace tolman::ros_bag {

inline constexpr std::string_view kCdrEncoding = "cdr";
inline constexpr std::string_view kRos1Encoding = "ros1";

struct Topic {
  std::string name;
  std::string type;      ///< in the notation of ROS 2: "sensor_msgs/msg/Image"
  std::string encoding;  ///< of the messages: "cdr" (ROS 2) or "ros1"
  bool operator==(const Topic&) const = default;
};

}  // namespace tolman::ros_bag
