// SPDX-License-Identifier: BSD-3-Clause
// The end of an MCAP file (mcap.dev): a summary, which repeats the schemas and channels and counts
// the messages of each channel, then a footer with its place. Both may be missing in a recording
// that was cut off; a sound file may have no summary.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "bytes.hpp"
#include "file_bytes.hpp"
#include "topic.hpp"

namespace tolman::ros_bag {

using ros_messages::ByteReader;
using ros_messages::Bytes;

constexpr std::uint64_t kMcapRecordHeader = 9;  ///< bytes: kind, then length of the contents

enum McapKind : std::uint8_t {
  kMcapFooter = 2,
  kMcapSchema = 3,
  kMcapChannel = 4,
  kMcapMessage = 5,
  kMcapChunk = 6,
  kMcapMessageIndex = 7,
  kMcapStatistics = 11,
  kMcapDataEnd = 15,
};

using McapTypes = std::map<std::uint16_t, std::string>;  ///< by the number of the schema
using McapTopics = std::map<std::uint16_t, Topic>;       ///< by the number of the channel

struct McapIndex {
  std::string problem;      ///< why it cannot be used: "is missing"; empty if it can be
  std::uint64_t begin = 0;  ///< where the data must end: at the summary, or at the footer
  McapTypes types;
  McapTopics topics;
  std::map<std::uint16_t, std::int64_t> messages;  ///< by the number of the channel; may be empty
  std::int64_t all_messages = 0;                   ///< 0 without statistics
};

McapIndex readMcapIndex(FileBytes& file);

/// Takes a record that declares a type; does nothing if it is damaged, see fields.ok().
void takeSchema(ByteReader& fields, McapTypes& types);
/// The same of a topic; false if its channel is already another topic.
bool takeChannel(ByteReader& fields, const McapTypes& types, McapTopics& topics);

}  // namespace tolman::ros_bag
