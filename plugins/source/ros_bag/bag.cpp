// SPDX-License-Identifier: BSD-3-Clause
#include "bag.hpp"

#include <algorithm>

#include "file_bytes.hpp"
#include "mcap_file.hpp"
#include "message_order.hpp"
#include "messages.hpp"
#include "metadata_file.hpp"
#include "ros1_file.hpp"
#include "sqlite_file.hpp"

namespace tolman::ros_bag {
namespace {

bool isUsed(const std::string& type) {
  return type == kImage || type == kCompressedImage || type == kCameraInfo || type == kImu ||
         type == kOdometry;
}

bool isImage(const Topic& topic) { return topic.type == kImage || topic.type == kCompressedImage; }

bool isKnown(const std::string& encoding) {
  return encoding == kCdrEncoding || encoding == kRos1Encoding;
}

/// How the camera of this CameraInfo differs from that of the topic's first; empty if it does not.
std::string cameraChange(const BagTopic& topic, const Message& message) {
  const auto first = readCameraInfo(topic.firstMessage());
  const auto now = readCameraInfo(message);
  if (!first || !now) return "";
  if (first->width != now->width || first->height != now->height) return "another image size";
  if (first->model != now->model || first->D != now->D) return "another distortion";
  if (first->K != now->K || first->P != now->P) return "another camera matrix";
  return first->R != now->R ? "another rotation" : "";
}

/// "odom, base_link": in which frame a pose is, and of which; empty if the message is damaged.
std::string framesOf(const Message& message) {
  const auto odometry = readOdometry(message);
  if (!odometry) return "";
  return std::string(odometry->frame) + ", " + std::string(odometry->child_frame);
}

/// Poses in two frames are two paths. The first message decides which is used.
bool isInOtherFrame(BagTopic& topic, Bytes bytes) {
  const std::string frame = framesOf(topic.message(bytes));
  if (topic.frame.empty()) topic.frame = frame;
  return !frame.empty() && frame != topic.frame;
}

/// Times of headers and of recording may be of two clocks (simulated time begins when the clock is
/// first published), so messages without a time in their header are left out if others have one.
void useOneClock(BagTopic& topic) {
  const auto without = std::ranges::count(topic.index, false, &BagMessage::has_stamp);
  if (without == 0 || without == std::ssize(topic.index)) return;
  topic.without_stamp = without;
  std::erase_if(topic.index, [](const BagMessage& message) { return !message.has_stamp; });
}

/// "message 2 (recorded at 5000000000 ns)": the latest of the topic, counted from 0.
std::string latestOf(const BagTopic& topic, std::int64_t log_ns) {
  return "message " + std::to_string(topic.messages - 1) + " (recorded at " +
         std::to_string(log_ns) + " ns)";
}

/// No message of images or poses has a time, and not because of a wrong clock, which is told
/// otherwise.
bool hasNoTimes(const BagTopic& topic) {
  const bool matters = isImage(topic.topic) || topic.topic.type == kOdometry;
  return matters && !topic.index.empty() && !topic.index.front().has_stamp && topic.negative == 0;
}

/// Leaves the visit of a file.
struct Interruption {};

}  // namespace

std::vector<std::string> BagTopic::messageProblems(bool times_matter) const {
  std::vector<std::string> texts;
  const std::string name = topic.name + ": ";
  if (damaged > 0) texts.push_back(name + first_damaged + furtherText(damaged));
  if (other_type > 0) {
    texts.push_back(name + std::to_string(other_type) +
                    " messages have another type or encoding than the first, " + topic.type);
  }
  if (!times_matter) return texts;
  if (negative > 0) {
    texts.push_back(name + first_negative + " in its header, before 1970" + furtherText(negative) +
                    ": its clock was wrong");
  }
  if (without_stamp > negative) {
    texts.push_back(name + std::to_string(without_stamp - negative) +
                    (isImage(topic) ? " images" : " messages") +
                    " have no time in their header, and others have one");
  }
  if (other_frame > 0) texts.push_back(name + first_other_frame + furtherText(other_frame));
  if (same_time > 0) texts.push_back(name + first_same_time + furtherText(same_time));
  return texts;
}

Result<Bag> Bag::open(const std::filesystem::path& path, const Cancellation& cancellation) {
  Result<std::vector<std::filesystem::path>> found = findBagFiles(path);
  if (!found.isOk()) return found.status();
  Bag bag;
  bag.paths_ = std::move(found).value();
  for (std::size_t file = 0; file < bag.paths_.size(); ++file) {
    if (Status status = bag.openFile(bag.paths_[file]); !status.isOk()) return status;
    try {
      bag.visit(file, cancellation);
    } catch (const Interruption&) {
      return Status(StatusCode::Cancelled, "reading was cancelled");
    }
  }
  bag.judgeCounts(path);
  for (auto& [name, topic] : bag.topics_) {
    useOneClock(topic);
    const std::string moved = movedText(topic);
    if (!moved.empty()) bag.warnings_.push_back(path.string() + ": " + moved);
    std::ranges::stable_sort(topic.index, {}, &BagMessage::stamp_ns);
    leaveOutSameTimes(topic, [&bag](const BagMessage& message) { return bag.read(message); });
    if (hasNoTimes(topic)) {
      bag.warnings_.push_back(path.string() + ": " + name +
                              ": no message has a time in its header; the times of recording are "
                              "used, which are later than those of the measurements");
    }
    if (topic.recorded_twice > 0) {
      bag.warnings_.push_back(path.string() + ": " + name + ": " +
                              std::to_string(topic.recorded_twice) +
                              (topic.recorded_twice == 1 ? " message is" : " messages are") +
                              " recorded twice, with the same time and the same bytes; "
                              "each is used once");
    }
  }
  return bag;
}

Status Bag::openFile(const std::filesystem::path& path) {
  Result<FileBytes> bytes = FileBytes::open(path);
  if (!bytes.isOk()) return bytes.status();
  if (McapFile::isMcap(bytes.value())) {
    files_.push_back(std::make_unique<McapFile>(std::move(bytes).value()));
    return Status::ok();
  }
  if (SqliteFile::isSqlite(bytes.value())) {
    auto database = SqliteFile::open(path, std::move(bytes).value());
    if (!database.isOk()) return database.status();
    files_.push_back(std::move(database).value());
    return Status::ok();
  }
  if (Ros1File::isRos1(bytes.value())) {
    auto bag = Ros1File::open(std::move(bytes).value());
    if (!bag.isOk()) return {bag.status().code(), path.string() + ": " + bag.status().message()};
    files_.push_back(std::move(bag).value());
    return Status::ok();
  }
  return Status::invalidInput(path.string() +
                              ": is no bag of ROS (.mcap, .db3 or .bag); check the path");
}

void Bag::visit(std::size_t file, const Cancellation& cancellation) {
  constexpr std::size_t kMaxProblems = 20;
  FileDamage damage;
  files_[file]->visit(
      [&](const Topic& topic, std::int64_t log_ns, const MessagePlace& place, Bytes bytes) {
        if (cancellation.requested()) throw Interruption();  // a bag may take many minutes
        add(topic, log_ns, {log_ns, file, place}, bytes);
      },
      damage);
  const std::vector<std::string>& problems = damage.problems;
  for (std::size_t i = 0; i < std::min(problems.size(), kMaxProblems); ++i) {
    problems_.push_back(paths_[file].string() + ": " + problems[i]);
  }
  if (problems.size() > kMaxProblems) {
    problems_.push_back(paths_[file].string() + ": has " +
                        std::to_string(problems.size() - kMaxProblems) + " more problems");
  }
  for (const auto& [name, lost] : damage.lost) {
    LostMessages& known = lost_[name];
    known.topic = lost.topic;
    known.messages += lost.messages;
  }
}

/// Compares what was found with what metadata.yaml says, and tells what is lost.
void Bag::judgeCounts(const std::filesystem::path& path) {
  const BagMetadata metadata = metadataOf(path);
  for (const auto& [name, of] : metadata.topics) {
    const auto topic = topics_.find(name);
    const std::int64_t found = topic == topics_.end() ? 0 : topic->second.messages;
    if (of.messages <= found) continue;
    LostMessages& lost = lost_[name];
    if (lost.topic.name.empty()) lost.topic = {name, of.type, of.encoding};
    lost.messages = std::max(lost.messages, of.messages - found);
  }
  // Then every lost message has its topic, also those that the files could not tell.
  if (!metadata.topics.empty()) lost_.erase("");
  std::int64_t found = 0;
  for (const auto& [name, topic] : topics_) found += topic.messages;
  std::int64_t all_lost = 0;
  for (const auto& [name, lost] : lost_) {
    all_lost += lost.messages;
    if (name.empty()) continue;
    BagTopic& topic = topics_[name];
    if (topic.messages == 0) topic.topic = lost.topic;
    topic.lost = lost.messages;
  }
  if (!lost_.empty()) {
    problems_.push_back(path.string() + ": " + lostMessages() +
                        " could not be read; copy the bag again, or use the others by on_corrupt: "
                        "skip");
  }
  const std::string missing = missingMessages(path, metadata, found);
  const bool is_told = metadata.messages && *metadata.messages <= found + all_lost;
  if (!missing.empty() && !is_told) problems_.push_back(missing);
  warnings_ = oddFiles(path, metadata, paths_);
}

void Bag::add(const Topic& topic, std::int64_t log_ns, const BagMessage& message, Bytes bytes) {
  BagTopic& known = topics_[topic.name];
  if (known.messages == 0) {
    known.topic = topic;
    known.first_ns = known.last_ns = log_ns;
  }
  ++known.messages;
  known.bytes += bytes.size();
  known.first_ns = std::min(known.first_ns, log_ns);
  known.last_ns = std::max(known.last_ns, log_ns);
  if (known.topic != topic) ++known.other_type;
  if (known.topic != topic || !isKnown(topic.encoding) || !isUsed(topic.type)) return;
  const std::optional<std::int64_t> stamp = headerStamp(known.message(bytes));
  if (!stamp) {
    constexpr std::size_t kStampBytes = 12;  // CDR: its kind and the time; ROS 1: number and time
    const char* what = bytes.empty()                ? " is empty"
                       : bytes.size() < kStampBytes ? " ends within its header"
                                                    : " has a damaged header";
    if (++known.damaged == 1) known.first_damaged = latestOf(known, log_ns) + what;
    return;
  }
  if (topic.type == kOdometry && isInOtherFrame(known, bytes)) {
    if (++known.other_frame == 1) {
      known.first_other_frame = latestOf(known, log_ns) + " is a pose in the frames '" +
                                framesOf(known.message(bytes)).substr(0, 80) +
                                "', and the first message in '" + known.frame.substr(0, 80) + "'";
    }
    return;
  }
  if (known.index.empty()) known.first.assign(bytes.begin(), bytes.end());
  known.index.push_back(message);
  known.index.back().number = known.messages - 1;
  known.index.back().has_stamp = *stamp > 0;
  known.index.back().log_ns = log_ns;
  known.index.back().stamp_ns = *stamp > 0 ? *stamp : log_ns;
  if (*stamp < 0 && ++known.negative == 1) {
    known.first_negative =
        latestOf(known, log_ns) + " has the time " + std::to_string(*stamp) + " ns";
  }
  if (topic.type == kCameraInfo && known.other_camera.empty()) {
    known.other_camera = cameraChange(known, known.message(bytes));
  }
}

Result<std::vector<std::uint8_t>> Bag::read(const BagMessage& message) {
  Result<std::vector<std::uint8_t>> bytes = files_[message.file]->read(message.place);
  if (bytes.isOk()) return bytes;
  return Status(bytes.status().code(),
                paths_[message.file].string() + ": " + bytes.status().message());
}

}  // namespace tolman::ros_bag
