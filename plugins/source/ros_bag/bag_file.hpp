// SPDX-License-Identifier: BSD-3-Clause
// One file of a bag: its topics, and its messages in the order of the file.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bytes.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

struct Topic {
  std::string name;
  std::string type;      ///< "sensor_msgs/msg/Image"
  std::string encoding;  ///< of the messages: "cdr"
  bool operator==(const Topic&) const = default;
};

/// Where a message stands in its file.
struct MessagePlace {
  std::uint64_t chunk = 0;   ///< .mcap: start of the compressed block that it is in; 0 for none
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
  /// Visits all messages that can be read. What cannot is told in `problems`, one text with a
  /// remedy each, without the name of the file.
  virtual void visit(const MessageVisitor& visitor, std::vector<std::string>& problems) = 0;
  /// The bytes of a message that was visited.
  virtual Result<std::vector<std::uint8_t>> read(const MessagePlace& place) = 0;
};

}  // namespace tolman::ros_bag
