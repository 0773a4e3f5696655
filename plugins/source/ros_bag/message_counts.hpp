// SPDX-License-Identifier: BSD-3-Clause
// How many messages of each channel (ROS 1: connection) a file should have, by its own indices, and
// how many were found. An index is a witness only: a file without one is read as it is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>

namespace tolman::ros_bag {

class MessageCounts {
 public:
  /// By an index beside a chunk.
  void indexChunk(std::uint32_t channel, std::int64_t messages) {
    of_[channel].indexed += messages;
  }
  /// By the index of the whole file.
  void indexFile(std::uint32_t channel, std::int64_t messages) { of_[channel].listed += messages; }
  /// All messages, by an index that may not tell the channels apart.
  void indexAll(std::int64_t messages) { all_ = messages; }
  /// A message that was found, also if it cannot be used.
  void find(std::uint32_t channel) { ++of_[channel].found; }

  /// Missing messages whose channel is not known.
  std::int64_t missingOfNone() const {
    std::int64_t missing = all_;
    for (const auto& [channel, counts] : of_)
      missing -= std::max({counts.indexed, counts.listed, counts.found});
    return std::max<std::int64_t>(0, missing);
  }
  /// Calls visit(channel, messages) for those of which messages are missing.
  template <class Visit>
  void visitMissing(Visit&& visit) const {
    for (const auto& [channel, counts] : of_) {
      const std::int64_t missing = std::max(counts.indexed, counts.listed) - counts.found;
      if (missing > 0) visit(channel, missing);
    }
  }

 private:
  struct Counts {
    std::int64_t indexed = 0;
    std::int64_t listed = 0;
    std::int64_t found = 0;
  };
  std::map<std::uint32_t, Counts> of_;
  std::int64_t all_ = 0;
};

}  // namespace tolman::ros_bag
