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
  std::int64_t log_ns = 0;  ///< time of recording
};

/// One topic and its messages.
struct BagTopic {
  Topic topic;
  std::int64_t messages = 0;
  std::uint64_t bytes = 0;
  std::int64_t first_ns = 0;        ///< time of recording
  std::int64_t last_ns = 0;         ///< time of recording
  std::vector<std::uint8_t> first;  ///< the first undamaged message, for types that are used
  std::vector<BagMessage> index;    ///< sorted by stamp, for types that are used
  std::int64_t lost = 0;            ///< messages that are in the bag, but could not be read
  std::int64_t other_type = 0;      ///< messages of another type or encoding, which are not used
  std::int64_t without_stamp = 0;   ///< messages left out, because only others have a time
  std::int64_t damaged = 0;         ///< messages left out, because their header is damaged
  std::string first_damaged;        ///< "message 2 (recorded at 5000000000 ns) is empty"
  std::int64_t negative = 0;   ///< messages whose header has a negative time, which is not used
  std::string first_negative;  ///< "message 0 (recorded at 5000000000 ns) has the time -1 ns"
  std::int64_t recorded_twice = 0;  ///< messages left out, because they are the one before
  std::int64_t same_time = 0;       ///< others left out, with the time of the one before
  std::string first_same_time;      ///< "messages 1 and 2 (counted from 0) have the time 5 ns"
  std::string frame;                ///< of poses, and whose they are: "odom, base_link"
  std::int64_t other_frame = 0;     ///< poses left out, because they are in another frame
  std::string first_other_frame;    ///< "message 2 (recorded at 5 ns) is a pose in the frames ..."
  std::string other_camera;         ///< how a later CameraInfo differs from the first; or empty

  /// These bytes as a message of the topic.
  Message message(Bytes of) const {
    return {of, topic.encoding == kRos1Encoding ? Encoding::Ros1 : Encoding::Cdr};
  }
  Message firstMessage() const { return message(first); }
  /// One text, without file and remedy, for each kind of messages that cannot be used as they are:
  /// damaged ones, and, if `times_matter`, those without a time or with that of another, and poses
  /// in other frames.
  std::vector<std::string> messageProblems(bool times_matter) const;
};

class Bag {
 public:
  /// Opens and reads the bag. Damage is reported in problems().
  static Result<Bag> open(const std::filesystem::path& path, const Cancellation& cancellation);

  /// Topics by name.
  const std::map<std::string, BagTopic>& topics() const { return topics_; }
  /// One text, with file and remedy, for each problem.
  const std::vector<std::string>& problems() const { return problems_; }
  /// One text, with file and remedy, for what is odd, but no damage.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// "12 messages of /left and 3 messages of topics that are not known"; empty if none is known to
  /// be lost. Of recordings that were cut off it is not known how many are.
  std::string lostMessages() const { return lostText(lost_); }
  Result<std::vector<std::uint8_t>> read(const BagMessage& message);

 private:
  Status openFile(const std::filesystem::path& path);
  void visit(std::size_t file, const Cancellation& cancellation);
  void judgeCounts(const std::filesystem::path& path);
  void add(const Topic& topic, std::int64_t log_ns, const BagMessage& message, Bytes bytes);

  std::vector<std::filesystem::path> paths_;
  std::vector<std::unique_ptr<BagFile>> files_;
  std::map<std::string, BagTopic> topics_;
  std::map<std::string, LostMessages> lost_;  ///< of all files
  std::vector<std::string> problems_;
  std::vector<std::string> warnings_;
};

}  // namespace tolman::ros_bag
