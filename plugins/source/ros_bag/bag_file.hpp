// SPDX-License-Identifier: BSD-3-Clause
// One file of a bag: its topics, and its messages in the order of the file.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "file_damage.hpp"
#include "message.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

using namespace ros_messages;  // the bytes of a bag are theirs

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
  /// Visits all messages that can be read. What cannot be is added to `damage`.
  virtual void visit(const MessageVisitor& visitor, FileDamage& damage) = 0;
  /// Reads the bytes of a visited message again.
  virtual Result<std::vector<std::uint8_t>> read(const MessagePlace& place) = 0;
};

}  // namespace tolman::ros_bag
