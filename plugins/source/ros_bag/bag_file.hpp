// SPDX-License-Identifier: BSD-3-Clause
// One file of a bag: its topics, and its messages in the order of the file.
#pragma once

#include <cstdint>
#include <functional>
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
  std::uint64_t chunk = 0;   ///< start of the compressed chunk that contains it; 0: none
  std::uint64_t offset = 0;  ///< in the chunk or the file; in a database its id
  std::uint64_t size = 0;    ///< bytes
};

/// Called with each message: topic, time of recording (ns), place and bytes, which are valid during
/// the call.
using MessageVisitor =
    std::function<void(const Topic&, std::int64_t log_ns, const MessagePlace&, Bytes)>;
/// Called with what cannot be read; the text completes the sentence "FILE ...".
using DamageVisitor = std::function<void(const std::string& what)>;

class BagFile {
 public:
  virtual ~BagFile() = default;
  /// Visits all messages that can be read, and what cannot be read.
  virtual void visit(const MessageVisitor& visitor, const DamageVisitor& damage) = 0;
  /// Reads the bytes of a visited message again.
  virtual Result<std::vector<std::uint8_t>> read(const MessagePlace& place) = 0;
};

inline std::string atByte(std::uint64_t at) { return " at byte " + std::to_string(at); }

}  // namespace tolman::ros_bag
