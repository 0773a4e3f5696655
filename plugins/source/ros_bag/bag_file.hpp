// SPDX-License-Identifier: BSD-3-Clause
// One file of a bag: its topics, and its messages in the order of the file.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "message.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

using namespace ros_messages;  // the bytes of a bag are theirs

inline constexpr std::string_view kCdrEncoding = "cdr";
inline constexpr std::string_view kRos1Encoding = "ros1";

struct Topic {
  std::string name;
  std::string type;      ///< in the notation of ROS 2: "sensor_msgs/msg/Image"
  std::string encoding;  ///< of the messages: "cdr" (ROS 2) or "ros1"
  bool operator==(const Topic&) const = default;
};

/// Place of a message in its file.
struct MessagePlace {
  std::uint64_t chunk = 0;   ///< .mcap: start of the compressed block that contains it; 0: none
  std::uint64_t offset = 0;  ///< .mcap: in the block or the file; .db3: its id
  std::uint64_t size = 0;    ///< bytes
};

/// Called with each message: topic, time of recording (ns), place and bytes, which are valid during
/// the call.
using MessageVisitor =
    std::function<void(const Topic&, std::int64_t log_ns, const MessagePlace&, Bytes)>;

class BagFile {
 public:
  virtual ~BagFile() = default;
  /// Visits all messages that can be read. For the others `problems` gets one text each, with a
  /// remedy and without the name of the file.
  virtual void visit(const MessageVisitor& visitor, std::vector<std::string>& problems) = 0;
  /// Reads the bytes of a visited message again.
  virtual Result<std::vector<std::uint8_t>> read(const MessagePlace& place) = 0;
};

}  // namespace tolman::ros_bag
