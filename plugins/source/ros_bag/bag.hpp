// SPDX-License-Identifier: BSD-3-Clause
// A bag and its files.
//
// One file of a bag: its topics, and its messages in the order of the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "messages.hpp"
#include "tolman/context.hpp"
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

// A whole bag, of one or several files: its topics, and the places of the messages that the source
// can use. It is read once from start to end when it is opened.

struct BagMessage {
  std::int64_t stamp_ns = 0;  ///< time of the header, or of recording if no header has one
  std::size_t file = 0;
  MessagePlace place;
  bool has_stamp = false;   ///< its header has a time
  bool is_key = true;       ///< of a video: decoding can begin here
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
