// SPDX-License-Identifier: BSD-3-Clause
// A whole bag, of one or several files: its topics, and the places of the messages that the source
// can use. It is read once from start to end when it is opened.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bag_file.hpp"
#include "tolman/context.hpp"

namespace tolman::ros_bag {

struct BagMessage {
  std::int64_t stamp_ns = 0;  ///< time of the header, or of recording if no header has one
  std::size_t file = 0;
  MessagePlace place;
  bool has_stamp = false;   ///< its header has a time
  std::int64_t number = 0;  ///< among the topic's messages, as they were recorded
};

/// One topic and its messages.
struct BagTopic {
  Topic topic;
  std::int64_t messages = 0;
  std::uint64_t bytes = 0;
  std::int64_t first_ns = 0;        ///< time of recording
  std::int64_t last_ns = 0;         ///< time of recording
  std::vector<std::uint8_t> first;  ///< the first usable message, for types that are used
  std::vector<BagMessage> index;    ///< sorted by stamp, for types that are used
  std::vector<Finding> findings;    ///< about its messages; of interest if the topic is used
  std::string other_camera;         ///< how a later CameraInfo differs from the first; or empty

  /// These bytes as a message of the topic.
  Message message(Bytes of) const {
    return {of, topic.encoding == kRos1Encoding ? Encoding::Ros1 : Encoding::Cdr};
  }
  Message firstMessage() const { return message(first); }
  bool isOf(std::string_view type) const { return topic.type == type; }
};

class Bag {
 public:
  /// Opens and reads the bag; damage of its files goes to `findings`.
  static Result<Bag> open(const std::filesystem::path& path, const Cancellation& cancellation,
                          FindingCollector& findings);

  /// Topics by name.
  const std::map<std::string, BagTopic>& topics() const { return topics_; }
  Result<std::vector<std::uint8_t>> read(const BagMessage& message);

 private:
  Status openFile(const std::filesystem::path& path);
  void visit(std::size_t file, const Cancellation& cancellation, FindingCollector& findings);
  void add(const Topic& topic, std::int64_t log_ns, BagMessage message, Bytes bytes);
  void sortByTime(BagTopic& topic);

  std::vector<std::filesystem::path> paths_;
  std::vector<std::unique_ptr<BagFile>> files_;
  std::map<std::string, BagTopic> topics_;
};

}  // namespace tolman::ros_bag
