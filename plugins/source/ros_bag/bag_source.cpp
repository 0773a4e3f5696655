// SPDX-License-Identifier: BSD-3-Clause
#include "bag_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "image_conversion.hpp"

namespace tolman::ros_bag {
namespace {

std::string shortNumber(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

/// "sensor_msgs/msg/Image, 120 messages at 10 Hz, 37.2 MB, 640x480 mono8"
std::string summary(const BagTopic& topic) {
  std::string text = topic.topic.type + ", " + std::to_string(topic.messages) +
                     (topic.messages == 1 ? " message" : " messages");
  if (topic.messages > 1 && topic.last_ns > topic.first_ns) {
    const double seconds = static_cast<double>(topic.last_ns - topic.first_ns) * 1e-9;
    text += " at " + shortNumber(static_cast<double>(topic.messages - 1) / seconds) + " Hz";
  }
  text += ", " + shortNumber(static_cast<double>(topic.bytes) * 1e-6) + " MB";
  if (topic.topic.encoding != kCdrEncoding) text += ", encoded as '" + topic.topic.encoding + "'";
  const auto image = topic.isOf(kImage) && !topic.first.empty()
                         ? ros_messages::readImage(topic.firstMessage())
                         : std::nullopt;
  if (!image) return text;
  return text + ", " + std::to_string(image->width) + "x" + std::to_string(image->height) + " " +
         std::string(image->encoding.substr(0, 40));
}

Finding warning(std::string where, std::string message, std::string remedy) {
  return {Finding::Severity::Warning, std::move(where), std::move(message), std::move(remedy),
          Finding::Kind::Unusual};
}

}  // namespace

Status BagSource::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  findings_ = &context.findings;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  return ready_ = prepare(context);
}

Status BagSource::prepare(const Context& context) {
  if (Status status = checkCombination(parameters_); !status.isOk()) return status;
  Result<Bag> bag = Bag::open(parameters_.path, context.cancellation, *findings_);
  if (!bag.isOk()) return bag.status();
  bag_ = std::move(bag).value();
  const auto chosen = chooseTopics(bag_->topics(), parameters_);
  if (chosen.isOk()) chosen_ = chosen.value();
  for (const auto& [name, topic] : bag_->topics()) {
    findings_->add({Finding::Severity::Note, name, summary(topic) + roleOf(topic)});
  }
  if (!chosen.isOk()) return chosen.status();
  for (const Finding& finding : chosen_.undecided) findings_->add(finding);
  Status status = reportTopics();
  if (status.isOk()) status = findSize();
  if (status.isOk()) status = makeRigs();
  if (status.isOk()) status = makeSequence();
  if (!status.isOk()) return status;
  const std::pair frames_ns(chosen_.left->index[table_.rows.front().left].stamp_ns,
                            chosen_.left->index[table_.rows.back().left].stamp_ns);
  if (chosen_.truth != nullptr) {
    status =
        truth_.load(*bag_, *chosen_.truth, TruthName::of(parameters_.truth), frames_ns, *findings_);
    if (!status.isOk()) return status;
  }
  auto side = loadMeasurements(*bag_, chosen_.imu, chosen_.odometry, frames_ns, *findings_);
  if (side.isOk()) side_ = std::move(side).value();
  return side.status();
}

std::int64_t BagSource::imageStampNs(std::int64_t source_index) const {
  return chosen_.left->index[table_.rows[static_cast<std::size_t>(source_index)].left].stamp_ns;
}

Status BagSource::reportTopics() const {
  const bool given = parameters_.isGiven();  // then CameraInfo is not used
  for (const BagTopic* topic :
       {chosen_.left, chosen_.right, chosen_.depth, chosen_.imu, chosen_.odometry, chosen_.truth,
        given ? nullptr : chosen_.left_info, given ? nullptr : chosen_.right_info}) {
    if (topic == nullptr) continue;
    for (const Finding& finding : topic->findings) findings_->add(finding);
    if (topic->index.empty()) {
      return Status::invalidInput(topic->topic.name +
                                  ": has no message that can be used; record it again");
    }
    if (!topic->other_camera.empty()) {
      return Status::invalidInput(
          topic->topic.name + ": a later message has " + topic->other_camera +
          " than the first; cut the bag there, or give pinhole and baseline");
    }
    if (!topic->isOf(kImage)) continue;
    const std::string doubt = ros_messages::doubtOfRows(topic->firstMessage());
    if (!doubt.empty()) findings_->add(warning("image 0 of " + topic->topic.name, doubt, ""));
  }
  return Status::ok();
}

Status BagSource::findSize() {
  const auto sizeOf = [&](const BagTopic& topic, std::size_t index) -> Result<ImageSize> {
    if (isVideo(topic.topic.type)) {
      const Result<Image> image = decode(topic, index);
      if (!image.isOk()) return image.status();
      return ImageSize{image.value().width(), image.value().height()};
    }
    const auto bytes = bag_->read(topic.index[index]);
    if (!bytes.isOk()) return bytes.status();
    return imageSize(topic.topic.type, topic.message(bytes.value()));
  };
  Status status;
  for (std::size_t i = 0; i < chosen_.left->index.size(); ++i) {
    const Result<ImageSize> size = sizeOf(*chosen_.left, i);
    status = size.status();
    if (!size.isOk()) continue;
    size_ = size.value();
    break;
  }
  if (!status.isOk()) {
    return Status::invalidInput(chosen_.left->topic.name + ": no message has an image (the last " +
                                status.message() + "); record it again");
  }
  if (chosen_.depth == nullptr) return Status::ok();
  const auto depth =
      convertDepth(chosen_.depth->topic.type, chosen_.depth->firstMessage(), depth_size_);
  if (depth.isOk()) return Status::ok();
  return Status::invalidInput(chosen_.depth->topic.name + ": the first message " +
                              depth.status().message() + "; name another topic");
}

Status BagSource::makeRigs() {
  const auto topic = [](const BagTopic& images, const BagTopic* info) {
    CameraTopic camera{images.topic.name, "", std::nullopt};
    if (info == nullptr) return camera;
    camera.info_name = info->topic.name;
    camera.info = info->firstMessage();
    return camera;
  };
  const CameraTopic left = topic(*chosen_.left, chosen_.left_info);
  std::optional<CameraTopic> right;
  if (chosen_.right != nullptr) right = topic(*chosen_.right, chosen_.right_info);
  Result<CameraRigs> rigs =
      ros_messages::makeRigs(parameters_, size_, left, right ? &*right : nullptr);
  if (!rigs.isOk()) return rigs.status();
  rigs_ = std::move(rigs).value();
  for (const Finding& finding : rigs_.findings) findings_->add(finding);
  return Status::ok();
}

Status BagSource::makeSequence() {
  Result<FrameTable> table = makeFrameTable(*chosen_.left, chosen_.right, chosen_.depth,
                                            std::llround(parameters_.tolerance * 1e9));
  if (!table.isOk()) return table.status();
  table_ = std::move(table).value();
  const auto alone = [&](const BagTopic* topic, std::size_t count, const char* what) {
    if (count == 0) return;
    findings_->add(warning(topic->topic.name,
                           "has " + std::to_string(count) + " images without a " + what +
                               " one within the tolerance, which are left out",
                           "set tolerance"));
  };
  alone(chosen_.left, table_.left_alone, "right");
  alone(chosen_.right, table_.right_alone, "left");
  if (table_.without_depth > 0) {
    findings_->add(warning(chosen_.depth->topic.name,
                           "has no image within the tolerance for " +
                               std::to_string(table_.without_depth) + " of " +
                               std::to_string(table_.rows.size()) + " frames",
                           "set tolerance"));
  }
  if (chosen_.depth != nullptr && depth_size_ != size_) {
    findings_->add(
        warning(chosen_.depth->topic.name,
                "has images of " + depth_size_.text() + ", and the camera of " + size_.text(),
                "take depth that is registered to the camera's image"));
  }
  std::vector<std::int64_t> stamps;
  for (const FrameRow& row : table_.rows) stamps.push_back(chosen_.left->index[row.left].stamp_ns);
  Result<FrameSequence> sequence = FrameSequence::make(parameters_, stamps);
  if (!sequence.isOk()) return sequence.status();
  sequence_ = std::move(sequence).value();
  return Status::ok();
}

Status BagSource::reset() {
  next_frame_ = 0;
  return ready_;
}

Status BagSource::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  const bool pair = chosen_.right != nullptr;
  const bool ros1 = chosen_.left->topic.encoding == kRos1Encoding;
  info.description = std::string(ros1 ? "ROS 1 bag, " : "ROS 2 bag, ") +
                     std::to_string(sequence_.size()) +
                     (pair ? " stereo pairs of " : " images of ") + chosen_.left->topic.name +
                     (pair ? " and " + chosen_.right->topic.name : "") + ", " + size_.text();
  info.description += rigs_.suffix();
  info.rig = rigs_.rectified;
  info.frames = sequence_.size();
  info.has_truth = !truth_.isEmpty();
  return Status::ok();
}

Status BagSource::rawRig(RawRig& rig) {
  if (!ready_.isOk()) return ready_;
  rig = rigs_.raw;
  return Status::ok();
}

Status BagSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  if (next_frame_ >= sequence_.size()) return Status::endOfStream();
  frame.frame = next_frame_++;  // also after a failure, so that a caller can skip the frame
  frame.stamp_ns = sequence_.stampNs(frame.frame);
  frame.source_index = sequence_.sourceIndex(frame.frame);
  const std::int64_t before = sequence_.sourceIndex(std::max<std::int64_t>(frame.frame - 1, 0));
  side_.measure(imageStampNs(before), imageStampNs(frame.source_index), frame.sensors);
  const auto truth = truth_.at(imageStampNs(frame.source_index));
  frame.has_truth = truth.has_value();
  if (truth) frame.T_world_camera_truth = *truth;
  const FrameRow& row = table_.rows[static_cast<std::size_t>(frame.source_index)];
  // Of a damaged image both of the pair are left out: one alone would look like a single camera.
  const auto leaveOut = [&](const BagTopic& topic, std::size_t index, const Status& status) {
    const std::string where = "image " + std::to_string(index) + " of " + topic.topic.name;
    if (status.code() != StatusCode::InvalidInput) {
      return Status(status.code(), where + " " + status.message());
    }
    findings_->add({Finding::Severity::Error, where, status.message(), "record it again",
                    Finding::Kind::Damaged});
    frame.left = frame.right = {};
    frame.defect = where + " " + status.message();
    return Status::ok();
  };
  if (chosen_.depth != nullptr) {
    Result<NamedArray> depth = readDepth(row);
    if (!depth.isOk()) return leaveOut(*chosen_.depth, *row.depth, depth.status());
    frame.sensors.push_back(std::move(depth).value());
  }
  Result<Image> left = readImage(*chosen_.left, row.left);
  if (!left.isOk()) return leaveOut(*chosen_.left, row.left, left.status());
  frame.left = std::move(left).value();
  if (chosen_.right == nullptr) return Status::ok();
  Result<Image> right = readImage(*chosen_.right, row.right);
  if (!right.isOk()) return leaveOut(*chosen_.right, row.right, right.status());
  frame.right = std::move(right).value();
  return Status::ok();
}

Result<Image> BagSource::decode(const BagTopic& topic, std::size_t index) {
  const auto packet = [&](std::size_t i) -> Result<std::vector<std::uint8_t>> {
    const auto bytes = bag_->read(topic.index[i]);
    if (!bytes.isOk()) return bytes.status();
    const auto video = ros_messages::readVideo(topic.topic.type, topic.message(bytes.value()));
    if (!video) return Status::invalidInput("is no complete message");
    return std::vector<std::uint8_t>(video->data.begin(), video->data.end());
  };
  auto& decoder = decoders_[&topic];
  if (decoder == nullptr) {
    const auto first = ros_messages::readVideo(topic.topic.type, topic.firstMessage());
    if (!first) return Status::invalidInput("has a first message that is not complete");
    auto opened = coded_video::PacketDecoder::open(first->codec, parameters_.colour);
    if (!opened.isOk()) return opened.status();
    decoder = std::move(opened).value();
  }
  return decoder->picture(
      index, {topic.index.size(), [&](std::size_t i) { return topic.index[i].is_key; }, packet});
}

Result<Image> BagSource::readImage(const BagTopic& topic, std::size_t index) {
  if (isVideo(topic.topic.type)) {
    Result<Image> image = decode(topic, index);
    if (!image.isOk()) return image;
    const ImageSize found{image.value().width(), image.value().height()};
    return found == size_ ? image : Status::invalidInput("has another size: " + found.text());
  }
  const auto bytes = bag_->read(topic.index[index]);
  if (!bytes.isOk()) return bytes.status();
  Result<Image> image =
      convertImage(topic.topic.type, topic.message(bytes.value()), parameters_.colour, size_,
                   chosen_.left->topic.name, used_bits_);
  if (!image.isOk()) return image;
  if (auto finding = used_bits_.endImage(topic.topic.name)) findings_->add(*std::move(finding));
  return image;
}

/// All 0 (unknown) without a depth image.
Result<NamedArray> BagSource::readDepth(const FrameRow& row) {
  const std::size_t pixels =
      static_cast<std::size_t>(depth_size_.width) * static_cast<std::size_t>(depth_size_.height);
  NamedArray depth{"depth", {depth_size_.height, depth_size_.width}, std::vector<float>(pixels)};
  if (!row.depth) return depth;
  const auto bytes = bag_->read(chosen_.depth->index[*row.depth]);
  if (!bytes.isOk()) return bytes.status();
  ImageSize size;
  auto values =
      convertDepth(chosen_.depth->topic.type, chosen_.depth->message(bytes.value()), size);
  if (!values.isOk()) return values.status();
  if (size != depth_size_) return Status::invalidInput("changes its size");
  depth.values = std::move(values).value();
  return depth;
}

Status BagSource::describe(std::vector<ArrayInfo>& arrays) const {
  side_.describe(arrays);
  if (chosen_.depth != nullptr) arrays.push_back(ros_messages::depthInfo());
  return Status::ok();
}

std::string BagSource::roleOf(const BagTopic& topic) const {
  const std::array<std::pair<const BagTopic*, const char*>, 8> roles = {
      {{chosen_.left, "left"},
       {chosen_.right, "right"},
       {chosen_.left_info, "left_info"},
       {chosen_.right_info, "right_info"},
       {chosen_.depth, "depth"},
       {chosen_.imu, "imu"},
       {chosen_.odometry, "odometry"},
       {chosen_.truth, "truth"}}};
  for (const auto& [used, name] : roles) {
    if (used == &topic) return std::string(", used as ") + name;
  }
  return "";
}

}  // namespace tolman::ros_bag
