// SPDX-License-Identifier: BSD-3-Clause
// The text of a metadata.yaml of rosbag2: the names of the files of a bag, in order, and the
// numbers of its messages. The keys of a list's entry may stand in any order, and lists may be
// indented or not, as the programs that write such files differ.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tolman::ros_bag {

/// What metadata.yaml says of one topic.
struct TopicCount {
  std::string type;
  std::string encoding;
  std::int64_t messages = 0;
};

struct BagMetadata {
  std::vector<std::string> files;            ///< `relative_file_paths`; may be empty
  std::optional<std::int64_t> messages;      ///< of all topics
  std::map<std::string, TopicCount> topics;  ///< by name; may be empty
};

BagMetadata parseMetadata(const std::string& text);

}  // namespace tolman::ros_bag
