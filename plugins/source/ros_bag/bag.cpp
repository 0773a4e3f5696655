// SPDX-License-Identifier: BSD-3-Clause
#include "bag.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "base/text_file.hpp"
#include "mcap_file.hpp"
#include "messages.hpp"
#include "ros1_file.hpp"
#include "sqlite_file.hpp"

namespace tolman::ros_bag {

namespace fs = std::filesystem;
namespace {

bool isImage(const BagTopic& topic) {
  return std::ranges::find(kImageTypes, topic.topic.type) != kImageTypes.end();
}

bool isUsed(const BagTopic& topic) {
  const bool is_known =
      topic.topic.encoding == kCdrEncoding || topic.topic.encoding == kRos1Encoding;
  return is_known && (isImage(topic) || topic.isOf(kCameraInfo) || topic.isOf(kImu) ||
                      isPoses(topic.topic.type));
}

bool isBagName(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".mcap") || name.ends_with(".db3") || name.ends_with(".bag") ||
         name.ends_with(".mcap.zstd") || name.ends_with(".db3.zstd");
}

/// bag_2 before bag_10.
bool comesBefore(const fs::path& a, const fs::path& b) {
  const std::string first = a.filename().string();
  const std::string second = b.filename().string();
  return first.size() != second.size() ? first.size() < second.size() : first < second;
}

/// The names of the files in the metadata.yaml of rosbag2; empty without one.
Result<std::vector<std::string>> namedFiles(const fs::path& metadata) {
  std::vector<std::string> names;
  std::error_code ignored;
  if (!fs::is_regular_file(metadata, ignored)) return names;
  try {
    const YAML::Node root = YAML::LoadFile(metadata.string());
    const YAML::Node files = root["rosbag2_bagfile_information"]["relative_file_paths"];
    for (const YAML::Node& file : files) names.push_back(file.as<std::string>());
  } catch (const YAML::Exception& failure) {
    return Status::invalidInput(metadata.string() + ": " + failure.what() +
                                "; write it anew (`ros2 bag reindex`), or remove it");
  }
  return names;
}

/// The file itself, or those in a folder, in the order of its metadata.yaml. Without one: all
/// .mcap, .db3 and .bag files by name.
Result<std::vector<fs::path>> findBagFiles(const fs::path& path) {
  std::error_code failure;
  if (!fs::is_directory(path, failure)) return std::vector<fs::path>{path};
  const Result<std::vector<std::string>> named = namedFiles(path / "metadata.yaml");
  if (!named.isOk()) return named.status();
  std::vector<fs::path> files;
  for (const std::string& name : named.value()) {
    // Only the file name: early versions wrote the folder, too, and no other folder may be read.
    files.push_back(path / fs::path(name).filename());
    if (fs::exists(files.back(), failure)) continue;
    return Status::invalidInput(
        files.back().string() +
        ": is missing, and metadata.yaml names it; copy the whole folder of the bag");
  }
  if (!files.empty()) return files;
  for (fs::directory_iterator entry(path, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (isBagName(entry->path())) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end(), comesBefore);
  if (!files.empty()) return files;
  return Status::invalidInput(path.string() + ": has no .mcap, .db3 or .bag file; check the path");
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

/// "message 2 of /left": the latest of the topic, counted from 0.
std::string latestOf(const BagTopic& topic) {
  return "message " + std::to_string(topic.messages - 1) + " of " + topic.topic.name;
}

Finding damagedMessage(const std::string& where, const std::string& what) {
  return {Finding::Severity::Error, where, what, "record it again", Finding::Kind::Damaged};
}

Finding contradiction(Finding::Severity severity, const std::string& where, std::string what,
                      std::string remedy) {
  return {severity, where, std::move(what), std::move(remedy), Finding::Kind::Contradiction};
}

/// Leaves the visit of a file.
struct Interruption {};

}  // namespace

Result<Bag> Bag::open(const fs::path& path, const Cancellation& cancellation,
                      FindingCollector& findings) {
  Result<std::vector<fs::path>> found = findBagFiles(path);
  if (!found.isOk()) return found.status();
  Bag bag;
  bag.paths_ = std::move(found).value();
  for (std::size_t file = 0; file < bag.paths_.size(); ++file) {
    if (Status status = bag.openFile(bag.paths_[file]); !status.isOk()) return status;
    try {
      bag.visit(file, cancellation, findings);
    } catch (const Interruption&) {
      return Status(StatusCode::Cancelled, "reading was cancelled");
    }
  }
  for (auto& [name, topic] : bag.topics_) bag.sortByTime(topic);
  return bag;
}

Status Bag::openFile(const fs::path& path) {
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

void Bag::visit(std::size_t file, const Cancellation& cancellation, FindingCollector& findings) {
  files_[file]->visit(
      [&](const Topic& topic, std::int64_t log_ns, const MessagePlace& place, Bytes bytes) {
        if (cancellation.requested()) throw Interruption();  // a bag may take many minutes
        add(topic, log_ns, {log_ns, file, place}, bytes);
      },
      [&](const std::string& what) {
        findings.add({Finding::Severity::Error, paths_[file].string(), what, "copy it again",
                      Finding::Kind::Damaged});
      });
}

void Bag::add(const Topic& topic, std::int64_t log_ns, BagMessage message, Bytes bytes) {
  BagTopic& known = topics_[topic.name];
  if (known.messages == 0) {
    known.topic = topic;
    known.first_ns = known.last_ns = log_ns;
  }
  message.number = known.messages++;
  known.bytes += bytes.size();
  known.first_ns = std::min(known.first_ns, log_ns);
  known.last_ns = std::max(known.last_ns, log_ns);
  if (known.topic != topic) {
    known.findings.push_back(damagedMessage(latestOf(known), "has another type than the first"));
    return;
  }
  if (!isUsed(known)) return;
  const std::optional<std::int64_t> stamp =
      isTransforms(topic.type) ? log_ns : headerStamp(known.message(bytes));  // each has its own
  if (!stamp) {
    known.findings.push_back(
        damagedMessage(latestOf(known), bytes.empty() ? "is empty" : "is damaged in its header"));
    return;
  }
  if (known.index.empty()) known.first.assign(bytes.begin(), bytes.end());
  message.has_stamp = *stamp > 0;
  if (message.has_stamp) message.stamp_ns = *stamp;
  if (isVideo(topic.type)) {
    const auto packet = readVideo(topic.type, known.message(bytes));
    message.is_key = packet && packet->is_key;
  }
  known.index.push_back(message);
  if (known.isOf(kCameraInfo) && known.other_camera.empty()) {
    known.other_camera = cameraChange(known, known.message(bytes));
  }
}

namespace {

/// Whether the only message without a time is the first, and as far before the second as that is
/// before the third: it was made at time 0, where a recording begins.
bool beginsAtZero(const std::vector<BagMessage>& index) {
  if (index.size() < 3 || index.front().has_stamp || !index[1].has_stamp) return false;
  const std::int64_t step_ns = index[2].stamp_ns - index[1].stamp_ns;
  return step_ns > 0 && std::abs(index[1].stamp_ns - step_ns) <= step_ns;
}

}  // namespace

/// Times of headers and of recording may be of two clocks (simulated time begins when the clock is
/// first published), so messages without a time in their header are left out if others have one.
void Bag::sortByTime(BagTopic& topic) {
  using Severity = Finding::Severity;
  const std::string& name = topic.topic.name;
  auto without = std::ranges::count(topic.index, false, &BagMessage::has_stamp);
  if (without == 1 && beginsAtZero(topic.index)) {
    topic.index.front().stamp_ns = without = 0;
    topic.index.front().has_stamp = true;
  }
  if (without > 0 && without < std::ssize(topic.index)) {
    topic.findings.push_back(
        contradiction(Severity::Error, name,
                      "has " + std::to_string(without) + " messages without a time in their header",
                      "record it again; they are left out"));
    std::erase_if(topic.index, [](const BagMessage& message) { return !message.has_stamp; });
  } else if (without > 0 && (isImage(topic) || isPoses(topic.topic.type))) {
    topic.findings.push_back(contradiction(
        Severity::Warning, name,
        "has no time in any header; the times of recording are used, which are later", ""));
  }
  if (!std::ranges::is_sorted(topic.index, {}, &BagMessage::stamp_ns)) {
    topic.findings.push_back(contradiction(
        Severity::Warning, name,
        "has messages before others that were recorded earlier, by the times in their headers",
        "they are taken in the order of these times"));
  }
  std::ranges::stable_sort(topic.index, {}, &BagMessage::stamp_ns);
  const auto key = std::ranges::find(topic.index, true, &BagMessage::is_key);
  if (key != topic.index.begin()) {
    topic.findings.push_back(
        contradiction(Severity::Warning, name,
                      "begins with " + std::to_string(key - topic.index.begin()) +
                          " packets of video that cannot be decoded without those before",
                      "they are left out"));
    topic.index.erase(topic.index.begin(), key);
  }
  const bool one_each = isPoses(topic.topic.type) && !isTransforms(topic.topic.type);
  if (!isImage(topic) && !one_each) return;
  const auto same = std::ranges::unique(topic.index, {}, &BagMessage::stamp_ns);
  if (same.empty()) return;
  topic.findings.push_back(
      contradiction(Severity::Warning, name,
                    "has " + std::to_string(same.size()) + " messages with the time of another",
                    "the first of each is used"));
  topic.index.erase(same.begin(), same.end());
}

Result<std::vector<std::uint8_t>> Bag::read(const BagMessage& message) {
  Result<std::vector<std::uint8_t>> bytes = files_[message.file]->read(message.place);
  if (bytes.isOk()) return bytes;
  return Status(bytes.status().code(),
                paths_[message.file].string() + ": " + bytes.status().message());
}

}  // namespace tolman::ros_bag
