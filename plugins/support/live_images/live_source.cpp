// SPDX-License-Identifier: BSD-3-Clause
#include "live_source.hpp"

#include <utility>

#include "image_conversion.hpp"

namespace tolman::live_images {

Status LiveImageSource::begin(Result<std::unique_ptr<Transport>> transport,
                              const LiveParameters& parameters, const Context& context) {
  parameters_ = parameters;
  findings_ = &context.findings;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  camera_.reset();
  next_image_ = next_frame_ = last_stamp_ns_ = 0;
  reported_left_out_ = reported_lost_ = 0;
  ready_ = transport.isOk() ? prepare(std::move(transport).value(), context) : transport.status();
  return ready_;
}

Status LiveImageSource::prepare(std::unique_ptr<Transport> transport, const Context& context) {
  if (Status status = ros_messages::checkCombination(parameters_); !status.isOk()) return status;
  auto opened = LiveCamera::open(std::move(transport), parameters_, context);
  if (!opened.isOk()) return opened.status();
  camera_ = std::move(opened).value();
  const auto unfit = [](const LiveStream& stream, const Status& status) {
    return Status(status.code(), "the first image of " + stream.topic + " " + status.message() +
                                     "; name another topic");
  };
  const LiveStream& left = camera_->streams().front();
  const auto size = ros_messages::imageSize(left.type, camera_->message(left.first));
  if (!size.isOk()) return unfit(left, size.status());
  size_ = size.value();
  if (!camera_->topics().depth.empty()) {
    const LiveStream& depth = camera_->streams().back();
    const auto first =
        ros_messages::convertDepth(depth.type, camera_->message(depth.first), depth_size_);
    if (!first.isOk()) return unfit(depth, first.status());
  }
  return makeRigs();
}

Status LiveImageSource::makeRigs() {
  const auto topic = [this](const LiveStream& stream) {
    ros_messages::CameraTopic camera{stream.topic, stream.info_topic, std::nullopt};
    if (!stream.info.empty()) camera.info = camera_->message(stream.info);
    return camera;
  };
  const auto left = topic(camera_->streams()[0]);
  std::optional<ros_messages::CameraTopic> right;
  if (hasPair()) right = topic(camera_->streams()[1]);
  auto rigs = ros_messages::makeRigs(parameters_, size_, left, right ? &*right : nullptr);
  if (!rigs.isOk()) return rigs.status();
  rigs_ = std::move(rigs).value();
  return Status::ok();
}

/// Images cannot be received again, so only a source that has given none can be reset.
Status LiveImageSource::reset() {
  if (!ready_.isOk() || next_image_ == 0) return ready_;
  return Status::unsupported("live images cannot be read twice; start the run again");
}

Status LiveImageSource::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  const LiveTopics& topics = camera_->topics();
  info.description = camera_->transport().name() + ", live " + topics.left;
  if (hasPair()) info.description += " and " + topics.right;
  info.description += ", " + size_.text();
  info.description += rigs_.suffix();
  info.rig = rigs_.rectified;
  return Status::ok();
}

Status LiveImageSource::rawRig(RawRig& rig) {
  if (!ready_.isOk()) return ready_;
  rig = rigs_.raw;
  return Status::ok();
}

Status LiveImageSource::describe(std::vector<ArrayInfo>& arrays) const {
  if (!ready_.isOk()) return ready_;
  camera_->measurements().describe(arrays);
  if (!camera_->topics().depth.empty()) arrays.push_back(ros_messages::depthInfo());
  return Status::ok();
}

Status LiveImageSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  while (parameters_.last < 0 || next_image_ <= parameters_.last) {
    ImageSet set;
    const Status status = camera_->next(set);
    reportDropped();
    if (status.code() == StatusCode::EndOfStream && !parameters_.end_when_silent) {
      return camera_->silence();
    }
    if (!status.isOk()) return status;
    const std::int64_t index = next_image_++;
    if (index % parameters_.step != 0) continue;
    frame.source_index = index;
    return give(set, frame);
  }
  return Status::endOfStream();
}

void LiveImageSource::reportDropped() {
  const std::string& topic = camera_->topics().left;
  const auto report = [&](std::size_t count, std::size_t& reported, const char* message,
                          const char* remedy) {
    for (; reported < count; ++reported) {
      findings_->add({Finding::Severity::Warning, topic, message, remedy});
    }
  };
  report(camera_->leftOut(), reported_left_out_,
         "an image without one of the other camera within the tolerance is left out",
         "set tolerance");
  report(camera_->lost(), reported_lost_, "an image was lost on the network",
         "raise net.core.rmem_max, publish reliably with reliable: true, or publish less");
}

Status LiveImageSource::give(const ImageSet& set, Frame& frame) {
  const std::int64_t stamp_ns = set.front().stamp_ns;
  const std::string& topic = camera_->topics().left;
  if (stamp_ns <= last_stamp_ns_) {
    return Status::invalidInput(
        stamp_ns == 0 ? topic + ": the images have no stamps; set them in the camera's node"
                      : topic + ": the time went back to " + std::to_string(stamp_ns) +
                            " ns, as where a bag is played again; start a run for each");
  }
  const std::int64_t before_ns = std::exchange(last_stamp_ns_, stamp_ns);
  frame.stamp_ns = stamp_ns;
  frame.frame = next_frame_++;
  camera_->measurements().measure(before_ns == 0 ? stamp_ns : before_ns, stamp_ns, frame.sensors);
  camera_->measurements().forgetBefore(stamp_ns);
  frame.defect = convert(set, frame);
  if (!frame.defect.empty()) frame.left = frame.right = {};  // one alone would look like one camera
  return Status::ok();
}

std::string LiveImageSource::convert(const ImageSet& set, Frame& frame) {
  const auto& streams = camera_->streams();
  const std::string& first = streams.front().topic;
  if (!camera_->topics().depth.empty()) {
    ros_messages::ImageSize size;
    auto depth =
        ros_messages::convertDepth(streams.back().type, camera_->message(set.back().message), size);
    const bool is_sound = depth.isOk() && size == depth_size_;
    frame.sensors.push_back(
        {"depth",
         {depth_size_.height, depth_size_.width},
         is_sound ? std::move(depth).value()
                  : std::vector<float>(static_cast<std::size_t>(depth_size_.height) *
                                       static_cast<std::size_t>(depth_size_.width))});
    if (!is_sound) {
      return defectOf(streams.back(), set.back(),
                      depth.isOk() ? Status::invalidInput("changes its size") : depth.status());
    }
  }
  for (std::size_t i = 0; i < (hasPair() ? 2U : 1U); ++i) {
    auto image = ros_messages::convertImage(streams[i].type, camera_->message(set[i].message),
                                            parameters_.colour, size_, first, used_bits_);
    if (auto found = used_bits_.endImage(streams[i].topic)) findings_->add(*std::move(found));
    if (!image.isOk()) return defectOf(streams[i], set[i], image.status());
    (i == 0 ? frame.left : frame.right) = std::move(image).value();
  }
  return "";
}

std::string LiveImageSource::defectOf(const LiveStream& stream, const Arrived& arrived,
                                      const Status& status) {
  const std::string where = stream.topic + ", stamp " + std::to_string(arrived.stamp_ns) + " ns";
  findings_->add({Finding::Severity::Error, where, status.message(), "mend the camera's node",
                  Finding::Kind::Damaged});
  return where + ": " + status.message();
}

}  // namespace tolman::live_images
