// SPDX-License-Identifier: BSD-3-Clause
#include "ros1_source.hpp"

#include "image_conversion.hpp"

namespace tolman::ros1 {
namespace {

ros_messages::Message asMessage(const std::vector<std::uint8_t>& bytes) {
  return {bytes, ros_messages::Encoding::Ros1};
}

}  // namespace

Status Ros1Source::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  log_ = &context.log;
  findings_ = &context.findings;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  return ready_ = prepare(context);
}

Status Ros1Source::prepare(const Context& context) {
  camera_.reset();
  next_image_ = next_frame_ = last_stamp_ns_ = 0;
  if (Status status = ros_messages::checkCombination(parameters_); !status.isOk()) return status;
  auto opened = LiveCamera::open(parameters_, context);
  if (!opened.isOk()) return opened.status();
  camera_ = std::move(opened).value();
  const auto size = ros_messages::imageSize(camera_->leftType(), asMessage(camera_->firstLeft()));
  if (!size.isOk()) {
    return {size.status().code(), "the first image of " + camera_->topics().left + " " +
                                      size.status().message() + "; name another topic"};
  }
  size_ = size.value();
  return makeRigs();
}

Status Ros1Source::makeRigs() {
  const auto topic = [](const std::string& images, const std::string& info, const auto& bytes) {
    ros_messages::CameraTopic camera{images, info, std::nullopt};
    if (!bytes.empty()) camera.info = asMessage(bytes);
    return camera;
  };
  const LiveTopics& topics = camera_->topics();
  const auto left = topic(topics.left, topics.left_info, camera_->leftInfo());
  const auto right = topic(topics.right, topics.right_info, camera_->rightInfo());
  auto rigs =
      ros_messages::makeRigs(parameters_, size_, left, topics.right.empty() ? nullptr : &right);
  if (!rigs.isOk()) return rigs.status();
  rigs_ = std::move(rigs).value();
  return Status::ok();
}

/// Images cannot be received again, so only a source that has given none can be reset.
Status Ros1Source::reset() {
  if (!ready_.isOk() || next_image_ == 0) return ready_;
  return Status::unsupported("live images cannot be read twice; start the run again");
}

Status Ros1Source::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  const LiveTopics& topics = camera_->topics();
  info.description = "ROS 1, live " + topics.left;
  if (!topics.right.empty()) info.description += " and " + topics.right;
  info.description +=
      ", " + std::to_string(size_.width) + "x" + std::to_string(size_.height) + " px";
  info.description += rigs_.suffix();
  info.rig = rigs_.rectified;
  return Status::ok();
}

Status Ros1Source::rawRig(RawRig& rig) {
  if (!ready_.isOk()) return ready_;
  rig = rigs_.raw;
  return Status::ok();
}

Status Ros1Source::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  while (parameters_.last < 0 || next_image_ <= parameters_.last) {
    ArrivedPair pair;
    const Status status = camera_->next(pair);
    if (status.code() == StatusCode::EndOfStream && !parameters_.end_when_silent) {
      return camera_->silence();
    }
    if (!status.isOk()) return status;
    tellLeftOut();
    const std::int64_t index = next_image_++;
    if (index % parameters_.step != 0) continue;
    frame.source_index = index;
    return give(pair, frame);
  }
  return Status::endOfStream();
}

void Ros1Source::tellLeftOut() {
  if (told_left_out_ || camera_->leftOut() == 0) return;
  told_left_out_ = true;
  log_->warning("images without one of the other camera within the tolerance are left out");
}

Status Ros1Source::give(const ArrivedPair& pair, Frame& frame) {
  const LiveTopics& topics = camera_->topics();
  if (pair.left.stamp_ns <= last_stamp_ns_) {
    return Status::invalidInput(
        pair.left.stamp_ns == 0
            ? topics.left + ": the images have no stamps; set them in the camera's node"
            : topics.left + ": the time went back to " + std::to_string(pair.left.stamp_ns) +
                  " ns, as where a bag is played again; start a run for each");
  }
  last_stamp_ns_ = frame.stamp_ns = pair.left.stamp_ns;
  frame.frame = next_frame_++;
  std::string defect = convert(topics.left, camera_->leftType(), pair.left, frame.left);
  if (defect.empty() && !topics.right.empty()) {
    defect = convert(topics.right, camera_->rightType(), pair.right, frame.right);
  }
  if (!defect.empty()) frame.left = frame.right = {};  // one alone would look like one camera
  frame.defect = defect;
  return Status::ok();
}

std::string Ros1Source::convert(const std::string& topic, const std::string& type,
                                const Arrived& arrived, Image& image) {
  auto converted = ros_messages::convertImage(type, asMessage(arrived.message), parameters_.colour,
                                              size_, camera_->topics().left, used_bits_);
  if (auto found = used_bits_.endImage(topic)) findings_->add(*std::move(found));
  if (converted.isOk()) {
    image = std::move(converted).value();
    return "";
  }
  const std::string where = topic + ", stamp " + std::to_string(arrived.stamp_ns) + " ns";
  findings_->add({Finding::Severity::Error, where, converted.status().message(),
                  "mend the camera's node", Finding::Kind::Damaged});
  return where + ": " + converted.status().message();
}

}  // namespace tolman::ros1
