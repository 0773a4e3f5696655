// SPDX-License-Identifier: BSD-3-Clause
#include "bag_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bag_problems.hpp"
#include "image_conversion.hpp"

namespace tolman::ros_bag {

using source_parameters::withoutAdvice;

namespace {

/// "sensor_msgs/msg/Image, 120 messages at 10 Hz, 37.2 MB"
std::string summary(const BagTopic& topic) {
  std::string text = topic.topic.type + ", " + std::to_string(topic.messages) +
                     (topic.messages == 1 ? " message" : " messages");
  if (topic.messages > 1 && topic.last_ns > topic.first_ns) {
    const double seconds = static_cast<double>(topic.last_ns - topic.first_ns) * 1e-9;
    text += " at " + shortNumber(static_cast<double>(topic.messages - 1) / seconds) + " Hz";
  }
  text += ", " + shortNumber(static_cast<double>(topic.bytes) * 1e-6) + " MB";
  if (topic.lost > 0) text += ", " + std::to_string(topic.lost) + " more could not be read";
  if (topic.topic.encoding != kCdrEncoding) text += ", encoded as '" + topic.topic.encoding + "'";
  const auto size =
      topic.first.empty() || (topic.topic.type != kImage && topic.topic.type != kCompressedImage)
          ? Result<ImageSize>(Status::failed(""))
          : imageSize(topic.topic.type, topic.firstMessage());
  if (!size.isOk()) return text;
  text += ", " + std::to_string(size.value().width) + "x" + std::to_string(size.value().height);
  const auto image = readImage(topic.firstMessage());
  const bool raw = image && topic.topic.type == kImage;
  return raw ? text + " " + std::string(image->encoding.substr(0, 40)) : text;
}

constexpr const char* kLeaveOut = "; leave them out by on_corrupt: skip";
constexpr const char* kAreLeftOut = "; what is damaged is left out";
constexpr const char* kWithoutThem =
    "; they are left out, or, where no header has a time, used by the time of recording";

std::string andMore(std::size_t more) {
  return more == 0 ? ""
                   : " (and " + std::to_string(more) + " more; `tolman dataset check` lists all)";
}

std::string sizeText(ImageSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height) + " px";
}

}  // namespace

Status BagSource::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  log_ = &context.log;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  return ready_ = prepare(context);
}

Status BagSource::prepare(const Context& context) {
  if (Status status = checkCombination(parameters_); !status.isOk()) return status;
  Result<Bag> bag = Bag::open(parameters_.path, context.cancellation);
  if (!bag.isOk()) return bag.status();
  bag_ = std::move(bag).value();
  Status status = judgeProblems(context.log);
  if (!status.isOk()) return status;
  const auto chosen = chooseTopics(bag_->topics(), parameters_);
  if (!chosen.isOk()) return chosen.status();
  chosen_ = chosen.value();
  for (const std::string& text : chosen_.undecided) {
    context.log.warning(parameters_.path + ": " + text);
  }
  status = judgeTopics(context.log);
  if (status.isOk()) status = findSize();
  if (status.isOk()) status = makeRigs();
  if (status.isOk()) status = makeSequence(context.log);
  if (status.isOk()) status = loadSensors(context.log);
  return status;
}

Status BagSource::loadSensors(Logger& log) {
  if (Status status = side_.load(*bag_, chosen_.imu, chosen_.odometry); !status.isOk()) {
    return status;
  }
  if (side_.damaged() == 0) return judgeOdometry(log);
  const std::string what = parameters_.path + ": " + std::to_string(side_.damaged()) +
                           " messages of other sensors are damaged, first " + side_.firstDamaged();
  if (parameters_.on_corrupt == OnCorrupt::Stop) return Status::invalidInput(what + kLeaveOut);
  log.warning(what);
  return judgeOdometry(log);
}

Status BagSource::judgeOdometry(Logger& log) {
  odometry_problems_.clear();
  if (chosen_.odometry == nullptr) return Status::ok();
  const std::string topic = chosen_.odometry->topic.name + ": ";
  // Two passes have every motion between frames; further ones are not counted.
  const auto most = static_cast<std::int64_t>(2 * table_.rows.size());
  std::vector<std::int64_t> frames_ns;
  for (std::int64_t i = 0; i < std::min(sequence_.size(), most); ++i) {
    frames_ns.push_back(imageStampNs(sequence_.sourceIndex(i)));
  }
  const Status status = side_.judgeOdometry(frames_ns, odometry_problems_);
  if (!status.isOk()) {
    const std::string what = topic + status.message();
    if (parameters_.on_corrupt == OnCorrupt::Stop) {
      return Status::invalidInput(parameters_.path + ": " + what +
                                  ", or leave the topic out by on_corrupt: skip");
    }
    odometry_problems_.push_back(status.message() + "; the topic is left out");
  }
  for (std::string& problem : odometry_problems_) {
    problem.insert(0, topic);
    log.warning(std::string(parameters_.path).append(": ").append(problem));
  }
  return Status::ok();
}

std::int64_t BagSource::imageStampNs(std::int64_t source_index) const {
  return chosen_.left->index[table_.rows[static_cast<std::size_t>(source_index)].left].stamp_ns;
}

Status BagSource::judgeProblems(Logger& log) const {
  const std::vector<std::string>& problems = bag_->problems();
  for (const std::string& warning : bag_->warnings()) log.warning(warning);
  if (problems.empty()) return Status::ok();
  if (parameters_.on_corrupt == OnCorrupt::Skip) {
    for (const std::string& problem : problems) log.warning(withoutAdvice(problem) + kAreLeftOut);
    return Status::ok();
  }
  return Status::invalidInput(problems.front() + andMore(problems.size() - 1));
}

/// The messages of the chosen topics that cannot be used as they are.
std::vector<std::string> BagSource::messageProblems() const {
  std::vector<std::string> all;
  const auto add = [&all](const BagTopic* topic, bool times_matter) {
    if (topic == nullptr) return;
    const auto problems = topic->messageProblems(times_matter);
    all.insert(all.end(), problems.begin(), problems.end());
  };
  for (const BagTopic* topic :
       {chosen_.left, chosen_.right, chosen_.depth, chosen_.imu, chosen_.odometry}) {
    add(topic, true);
  }
  if (parameters_.isGiven()) return all;  // CameraInfo is not used
  for (const BagTopic* topic : {chosen_.left_info, chosen_.right_info}) add(topic, false);
  return all;
}

/// What is odd in the first images of the chosen topics, but may be right.
std::vector<std::string> BagSource::imageDoubts() const {
  std::vector<std::string> all;
  for (const BagTopic* topic : {chosen_.left, chosen_.right, chosen_.depth}) {
    if (topic == nullptr || topic->topic.type != kImage || topic->index.empty()) continue;
    const std::string doubt = ros_messages::doubtOfRows(topic->firstMessage());
    if (!doubt.empty()) all.push_back(topic->topic.name + ": the first image " + doubt);
  }
  return all;
}

/// What is odd in the depth images beside those of the camera, but may be right; after the table.
std::vector<std::string> BagSource::depthDoubts() const {
  std::vector<std::string> all;
  if (chosen_.depth == nullptr) return all;
  const std::string topic = chosen_.depth->topic.name + ": ";
  if (table_.without_depth > 0) {
    all.push_back(topic + std::to_string(table_.without_depth) + " of " +
                  std::to_string(table_.rows.size()) +
                  " frames have no depth image within the tolerance; set tolerance");
  }
  if (depth_size_ != size_) {
    all.push_back(topic + "its images have " + sizeText(depth_size_) + ", those of the camera " +
                  sizeText(size_) + "; take depth that is registered to the camera's image");
  }
  return all;
}

/// Refuses damaged messages, wrong clocks, messages without times between others, and cameras that
/// change within the bag.
Status BagSource::judgeTopics(Logger& log) const {
  const std::vector<std::string> problems = messageProblems();
  if (!problems.empty() && parameters_.on_corrupt == OnCorrupt::Stop) {
    return Status::invalidInput(problems.front() + kLeaveOut + andMore(problems.size() - 1));
  }
  for (const std::string& problem : problems) log.warning(problem + kWithoutThem);
  for (const std::string& doubt : imageDoubts()) log.warning(parameters_.path + ": " + doubt);
  const bool given = parameters_.isGiven();  // then CameraInfo is not used
  for (const BagTopic* topic :
       {chosen_.left, chosen_.right, chosen_.depth, chosen_.imu, chosen_.odometry,
        given ? nullptr : chosen_.left_info, given ? nullptr : chosen_.right_info}) {
    if (topic == nullptr || !topic->index.empty()) continue;
    if (topic->damaged == 0) {
      return Status::invalidInput(
          topic->topic.name + ": none of its " + std::to_string(topic->lost) +
          " messages could be read; copy the bag again, or record it again");
    }
    return Status::invalidInput(topic->topic.name + ": " + topic->first_damaged +
                                ", and so is every other; record it again");
  }
  if (given) return Status::ok();
  for (const BagTopic* info : {chosen_.left_info, chosen_.right_info}) {
    if (info == nullptr || info->other_camera.empty()) continue;
    return Status::invalidInput(info->topic.name + ": a later message has " + info->other_camera +
                                " than the first; cut the bag there, or give fx and baseline");
  }
  return Status::ok();
}

Status BagSource::findSize() {
  Status status;
  for (const BagMessage& message : chosen_.left->index) {
    const auto bytes = bag_->read(message);
    const auto size =
        bytes.isOk() ? imageSize(chosen_.left->topic.type, chosen_.left->message(bytes.value()))
                     : Result<ImageSize>(bytes.status());
    status = size.status();
    if (!size.isOk()) continue;
    size_ = size.value();
    break;
  }
  if (!status.isOk()) {
    return Status::invalidInput(chosen_.left->topic.name + ": no message has a sound image (the " +
                                "last " + status.message() + "); record it again");
  }
  if (chosen_.depth == nullptr) return Status::ok();
  const auto depth = convertDepth(chosen_.depth->firstMessage(), depth_size_);
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
  return Status::ok();
}

Status BagSource::makeSequence(Logger& log) {
  Result<FrameTable> table = makeFrameTable(*chosen_.left, chosen_.right, chosen_.depth,
                                            std::llround(parameters_.tolerance * 1e9));
  if (!table.isOk()) return table.status();
  table_ = std::move(table).value();
  if (table_.left_alone > 0) {
    log.warning(parameters_.path + ": " + std::to_string(table_.left_alone) + " images of " +
                chosen_.left->topic.name + " have no right one within the tolerance");
  }
  if (table_.right_alone > 0) {
    log.warning(parameters_.path + ": " + std::to_string(table_.right_alone) + " images of " +
                chosen_.right->topic.name + " have no left one within the tolerance");
  }
  for (const std::string& doubt : depthDoubts()) log.warning(parameters_.path + ": " + doubt);
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
                     (pair ? " and " + chosen_.right->topic.name : "") + ", " + sizeText(size_);
  info.description += rigs_.suffix();
  const std::string lost = bag_->lostMessages();
  if (!lost.empty()) info.description += "; " + lost + " could not be read";
  info.rig = rigs_.rectified;
  info.frames = sequence_.size();
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
  const FrameRow& row = table_.rows[static_cast<std::size_t>(frame.source_index)];
  Status status = addDepth(row, frame);
  if (status.isOk()) status = readImages(row, frame);
  tellUsedBits();
  return source_parameters::finishFrame(status, parameters_.on_corrupt, frame);
}

void BagSource::tellUsedBits() {
  const bool is_last = next_frame_ == sequence_.size();
  if (const auto warning = used_bits_.warning(is_last, next_frame_ - 1)) {
    log_->warning(parameters_.path + ": " + chosen_.left->topic.name + ": " + *warning);
  }
}

Status BagSource::readImages(const FrameRow& row, Frame& frame) {
  Status status = readImage(*chosen_.left, row.left, frame.left);
  if (status.isOk() && chosen_.right != nullptr) {
    status = readImage(*chosen_.right, row.right, frame.right);
  }
  return status;
}

Status BagSource::readImage(const BagTopic& topic, std::size_t index, Image& image) {
  const BagMessage& message = topic.index[index];
  const auto bytes = bag_->read(message);
  ros_messages::DeepPixels deep{parameters_.bits};
  Result<Image> converted =
      bytes.isOk() ? convertImage(topic.topic.type, topic.message(bytes.value()),
                                  parameters_.colour, size_, chosen_.left->topic.name, deep)
                   : Result<Image>(bytes.status());
  const Status status = converted.status();
  used_bits_.add(deep.widths);
  if (const auto warning = used_bits_.beyond(deep.widths.largest())) {
    log_->warning(parameters_.path + ": image " + std::to_string(index) + " of " +
                  topic.topic.name + " " + *warning);
  }
  if (status.isOk()) {
    image = std::move(converted).value();
    return status;
  }
  return {status.code(), parameters_.path + ": image " + std::to_string(index) + " of " +
                             topic.topic.name + " (stamp " + std::to_string(message.stamp_ns) +
                             " ns) " + status.message() +
                             "; record it again, or leave it out by on_corrupt: skip"};
}

/// Adds the depth of a frame; all 0 (unknown) without a depth image.
Status BagSource::addDepth(const FrameRow& row, Frame& frame) {
  if (chosen_.depth == nullptr) return Status::ok();
  const std::size_t pixels =
      static_cast<std::size_t>(depth_size_.width) * static_cast<std::size_t>(depth_size_.height);
  NamedArray depth{"depth", {depth_size_.height, depth_size_.width}, std::vector<float>(pixels)};
  Status status;
  if (row.depth) {
    const auto bytes = bag_->read(chosen_.depth->index[*row.depth]);
    ImageSize size;
    auto values = bytes.isOk() ? convertDepth(chosen_.depth->message(bytes.value()), size)
                               : Result<std::vector<float>>(bytes.status());
    status = values.status();
    if (status.isOk() && size == depth_size_) depth.values = std::move(values).value();
    if (status.isOk() && size != depth_size_) status = Status::invalidInput("changes its size");
  }
  frame.sensors.push_back(std::move(depth));
  if (status.isOk()) return status;
  return {status.code(), parameters_.path + ": image " + std::to_string(*row.depth) + " of " +
                             chosen_.depth->topic.name + " " + status.message() +
                             "; record it again, or leave it out by on_corrupt: skip"};
}

Status BagSource::describe(std::vector<ArrayInfo>& arrays) const {
  side_.describe(arrays);
  if (chosen_.depth == nullptr) return Status::ok();
  ArrayInfo& info = arrays.emplace_back();
  info.name = "depth";
  info.kind = ArrayKind::DepthImage;
  info.unit = "m";
  info.doc = "depth along the optical axis, 0 where it is not known";
  info.axes.resize(2);
  info.axes[0].name = "row";
  info.axes[1].name = "column";
  return Status::ok();
}

std::string BagSource::roleOf(const BagTopic& topic) const {
  const std::array<std::pair<const BagTopic*, const char*>, 7> roles = {
      {{chosen_.left, "left"},
       {chosen_.right, "right"},
       {chosen_.left_info, "left_info"},
       {chosen_.right_info, "right_info"},
       {chosen_.depth, "depth"},
       {chosen_.imu, "imu"},
       {chosen_.odometry, "odometry"}}};
  for (const auto& [used, name] : roles) {
    if (used == &topic) return std::string(", used as ") + name;
  }
  return "";
}

void BagSource::inspectTopics(std::vector<Finding>& findings) const {
  for (const auto& [name, topic] : bag_->topics()) {
    findings.push_back({Finding::Severity::Note, name, summary(topic) + roleOf(topic)});
  }
}

Status BagSource::inspect(std::vector<Finding>& findings) {
  using Severity = Finding::Severity;
  const bool skip = parameters_.on_corrupt == OnCorrupt::Skip;
  if (bag_) {
    inspectTopics(findings);
    for (const std::string& warning : bag_->warnings()) {
      findings.push_back({Severity::Warning, "", warning});
    }
    for (const std::string& problem : bag_->problems()) {
      if (skip) findings.push_back({Severity::Warning, "", withoutAdvice(problem) + kAreLeftOut});
      if (!skip) findings.push_back({Severity::Error, "", problem});
    }
  }
  for (const std::string& problem : messageProblems()) {
    if (skip) findings.push_back({Severity::Warning, "", problem + kWithoutThem});
    if (!skip) findings.push_back({Severity::Error, "", problem + kLeaveOut});
  }
  for (const std::string& doubt : imageDoubts()) {
    findings.push_back({Severity::Warning, "", doubt});
  }
  const bool told = !skip && bag_ && !(bag_->problems().empty() && messageProblems().empty());
  if (!ready_.isOk()) {
    if (!told) findings.push_back({Severity::Error, "", ready_.message()});
    return Status::ok();
  }
  SourceInfo found;
  if (Status status = info(found); !status.isOk()) return status;
  if (table_.left_alone > 0) {
    findings.push_back({Severity::Warning, chosen_.left->topic.name,
                        std::to_string(table_.left_alone) +
                            " images have no right one within the tolerance; set tolerance"});
  }
  if (table_.right_alone > 0) {
    findings.push_back({Severity::Warning, chosen_.right->topic.name,
                        std::to_string(table_.right_alone) +
                            " images have no left one within the tolerance; set tolerance"});
  }
  for (const auto& problems : {depthDoubts(), odometry_problems_, chosen_.undecided}) {
    for (const std::string& problem : problems)
      findings.push_back({Severity::Warning, "", problem});
  }
  findings.push_back({Severity::Note, parameters_.path, found.description});
  return Status::ok();
}

}  // namespace tolman::ros_bag
