// SPDX-License-Identifier: BSD-3-Clause
#include "live_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace tolman::live_images {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::string seconds(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g s", value);
  return text.data();
}

}  // namespace

Result<std::unique_ptr<LiveCamera>> LiveCamera::open(std::unique_ptr<Transport> transport,
                                                     const LiveParameters& parameters,
                                                     const Context& context) {
  std::unique_ptr<LiveCamera> camera(new LiveCamera(std::move(transport), parameters, context));
  Status status = camera->findTopics();
  if (status.isOk()) status = camera->subscribe();
  if (status.isOk()) status = camera->waitForFirst();
  if (!status.isOk()) return status;
  return camera;
}

std::int64_t LiveCamera::deadline() const {
  return clock_.steadyNs() + std::llround(parameters_.wait * kSecond_ns);
}

Status LiveCamera::pause() {
  if (cancellation_.requested()) return {StatusCode::Cancelled, "waiting for images was cancelled"};
  transport_->process();
  return Status::ok();
}

/// Nodes and their topics appear one after the other: the choice is made when no more come.
Status LiveCamera::findTopics() {
  constexpr std::int64_t kSettled_ns = kSecond_ns / 2;
  const std::int64_t end = deadline();
  std::map<std::string, std::string> published;
  for (std::int64_t since = clock_.steadyNs();;) {
    auto now = transport_->topics();
    if (now != published) since = clock_.steadyNs();
    published = std::move(now);
    const auto chosen = chooseLiveTopics(published, parameters_, transport_->command());
    const bool is_settled = clock_.steadyNs() - since > kSettled_ns;
    const bool is_over = clock_.steadyNs() > end;
    if (chosen.isOk() && (is_settled || is_over)) {
      topics_ = chosen.value();
      for (const auto& [images, info] : {std::pair(topics_.left, topics_.left_info),
                                         std::pair(topics_.right, topics_.right_info),
                                         std::pair(topics_.depth, std::string())}) {
        if (images.empty()) continue;
        streams_.push_back({images, ros2Type(published.at(images)), {}, info, {}});
      }
      return Status::ok();
    }
    // Missing topics may still be published later.
    const bool may_come = chosen.status().code() == StatusCode::InvalidInput || !is_settled;
    if (!chosen.isOk() && (!may_come || is_over)) return chosen.status();
    if (Status status = pause(); !status.isOk()) return status;
  }
}

Status LiveCamera::subscribe() {
  sets_ = ImageSets(streams_.size(), std::llround(parameters_.tolerance * kSecond_ns));
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    LiveStream& stream = streams_[i];
    Status status = transport_->subscribe(stream.topic, stream.type, [this, i](Bytes bytes) {
      std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
      if (streams_[i].first.empty()) streams_[i].first = copy;
      const auto stamp_ns = headerStamp(message(copy));
      sets_.add(i, {stamp_ns.value_or(0), std::move(copy)});
    });
    if (status.isOk() && !stream.info_topic.empty()) {
      status = transport_->subscribe(
          stream.info_topic, std::string(ros_messages::kCameraInfo),
          [&info = stream.info](Bytes bytes) { info.assign(bytes.begin(), bytes.end()); });
    }
    if (!status.isOk()) return status;
  }
  return subscribeMeasurements();
}

Status LiveCamera::subscribeMeasurements() {
  using ros_messages::SideMeasurements;
  measurements_ = SideMeasurements(!topics_.imu.empty(), !topics_.odometry.empty());
  const auto listen = [this](const std::string& topic, std::string_view type, auto add) {
    if (topic.empty()) return Status::ok();
    Sensor& sensor = sensors_[topic];
    return transport_->subscribe(topic, std::string(type), [this, &sensor, topic, add](Bytes of) {
      const ros_messages::Message message{of, transport_->encoding()};
      const auto stamp_ns = headerStamp(message);
      if (stamp_ns && (measurements_.*add)(message, *stamp_ns)) {
        sensor = {*stamp_ns, false};
        return;
      }
      findings_.add({Finding::Severity::Error, topic, "a message is damaged", "mend its node",
                     Finding::Kind::Damaged});
    });
  };
  Status status = listen(topics_.imu, ros_messages::kImu, &SideMeasurements::addImu);
  if (!status.isOk()) return status;
  return listen(topics_.odometry, ros_messages::kOdometry, &SideMeasurements::addPose);
}

std::string LiveCamera::missing() const {
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    if (!sets_.has(i)) return streams_[i].topic;
    if (!streams_[i].info_topic.empty() && streams_[i].info.empty()) return streams_[i].info_topic;
  }
  return "";
}

Status LiveCamera::waitForFirst() {
  for (const std::int64_t end = deadline(); !missing().empty();) {
    if (Status status = pause(); !status.isOk()) return status;
    if (clock_.steadyNs() <= end) continue;
    const std::string topic = missing();
    const std::string misfit = transport_->misfit(topic);
    return Status::invalidInput(
        "nothing came on " + topic + " within " + seconds(parameters_.wait) +
        (misfit.empty()
             ? "; is the camera connected? (`" + transport_->command() + " hz " + topic + "`)"
             : misfit));
  }
  return Status::ok();
}

Status LiveCamera::next(ImageSet& set) {
  for (const std::int64_t end = deadline();;) {
    if (auto taken = sets_.take()) {
      set = std::move(*taken);
      return waitForMeasurements(set.front().stamp_ns);
    }
    if (clock_.steadyNs() > end) return Status::endOfStream();
    if (Status status = pause(); !status.isOk()) return status;
  }
}

/// Measurements of the time of an image may come after it: odometry of 10 Hz by 0.1 s.
Status LiveCamera::waitForMeasurements(std::int64_t stamp_ns) {
  const std::int64_t end = clock_.steadyNs() + kSecond_ns / 4;
  for (auto& [topic, sensor] : sensors_) {
    while (sensor.last_ns < stamp_ns && !sensor.is_late) {
      sensor.is_late = clock_.steadyNs() > end;
      if (Status status = pause(); !status.isOk()) return status;
    }
  }
  return Status::ok();
}

std::size_t LiveCamera::lost() const {
  std::size_t all = 0;
  for (const LiveStream& stream : streams_) all += transport_->lost(stream.topic);
  return all;
}

Status LiveCamera::silence() const {
  const std::string since = " for " + seconds(parameters_.wait);
  const std::string& first = streams_.front().topic;
  if (const std::string outage = transport_->outage(); !outage.empty()) {
    return Status::invalidInput("no image came on " + first + since + outage +
                                "; start both again, and go on with --continue");
  }
  std::string others;
  for (const LiveStream& stream : streams_) {
    if (&stream != &streams_.front()) {
      others += (others.empty() ? " with one on " : " and ") + stream.topic;
    }
    if (transport_->publishers(stream.topic) > 0) continue;
    return Status::invalidInput("no image came on " + stream.topic + since +
                                ": nobody publishes it any more; start the camera's node again, "
                                "and go on with --continue");
  }
  return Status::invalidInput("no image came on " + first + others + since + transport_->hang() +
                              ", and go on with --continue");
}

}  // namespace tolman::live_images
