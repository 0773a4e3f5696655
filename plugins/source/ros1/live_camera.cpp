// SPDX-License-Identifier: BSD-3-Clause
#include "live_camera.hpp"

#include <cmath>
#include <cstdio>

#include "messages.hpp"
#include "raw_message.hpp"

namespace tolman::ros1 {
namespace {

constexpr std::uint32_t kQueued = 100;  // messages that roscpp keeps for a topic

using Raw = boost::shared_ptr<const ros1_node::RawMessage>;

std::string seconds(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g s", value);
  return text.data();
}

}  // namespace

Result<std::unique_ptr<LiveCamera>> LiveCamera::open(const Ros1Parameters& parameters,
                                                     const Context& context) {
  std::unique_ptr<LiveCamera> camera(new LiveCamera(parameters, context));
  auto node = ros1_node::Node::start(parameters.master);
  if (!node.isOk()) return node.status();
  camera->node_ = std::move(node).value();
  Status status = camera->findTopics();
  if (!status.isOk()) return status;
  camera->subscribe();
  status = camera->waitForFirst();
  if (!status.isOk()) return status;
  return camera;
}

std::int64_t LiveCamera::deadline() const {
  return clock_.steadyNs() + std::llround(parameters_.wait * 1e9);
}

Status LiveCamera::pause() {
  if (cancellation_.requested()) return {StatusCode::Cancelled, "waiting for images was cancelled"};
  node_->queue().callAvailable(ros::WallDuration(0.02));
  return Status::ok();
}

Status LiveCamera::findTopics() {
  const std::int64_t end = deadline();
  while (true) {
    const auto published = node_->topics();
    const Result<LiveTopics> chosen = chooseLiveTopics(published, parameters_);
    if (chosen.isOk()) {
      topics_ = chosen.value();
      left_type_ = ros2Type(published.at(topics_.left));
      if (!topics_.right.empty()) right_type_ = ros2Type(published.at(topics_.right));
      return Status::ok();
    }
    // Missing topics may still be published later.
    const bool may_come = chosen.status().code() == StatusCode::InvalidInput;
    if (!may_come || clock_.steadyNs() > end) return chosen.status();
    if (Status status = pause(); !status.isOk()) return status;
  }
}

void LiveCamera::subscribe() {
  queue_ = PairQueue(!topics_.right.empty(), std::llround(parameters_.tolerance * 1e9));
  const auto listen = [this](const std::string& topic, auto handle) {
    const boost::function<void(const Raw&)> callback = [handle](const Raw& raw) {
      handle(raw->bytes);
    };
    subscribers_.push_back(
        node_->handle().subscribe<ros1_node::RawMessage>(topic, kQueued, callback));
  };
  const auto arrived = [](const std::vector<std::uint8_t>& bytes) {
    const auto stamp =
        ros_messages::headerStamp(ros_messages::Message(bytes, ros_messages::Encoding::Ros1));
    return Arrived{stamp.value_or(0), bytes};
  };
  listen(topics_.left, [this, arrived](const auto& bytes) {
    if (first_left_.empty()) first_left_ = bytes;
    queue_.addLeft(arrived(bytes));
  });
  if (!topics_.right.empty()) {
    listen(topics_.right, [this, arrived](const auto& b) { queue_.addRight(arrived(b)); });
  }
  if (!topics_.left_info.empty()) {
    listen(topics_.left_info, [this](const auto& bytes) { left_info_ = bytes; });
  }
  if (!topics_.right_info.empty()) {
    listen(topics_.right_info, [this](const auto& bytes) { right_info_ = bytes; });
  }
}

Status LiveCamera::waitForFirst() {
  const auto missing = [this]() -> const std::string* {
    if (!queue_.hasLeft()) return &topics_.left;
    if (!topics_.right.empty() && !queue_.hasRight()) return &topics_.right;
    if (!topics_.left_info.empty() && left_info_.empty()) return &topics_.left_info;
    if (!topics_.right_info.empty() && right_info_.empty()) return &topics_.right_info;
    return nullptr;
  };
  for (const std::int64_t end = deadline(); missing() != nullptr;) {
    if (Status status = pause(); !status.isOk()) return status;
    if (clock_.steadyNs() <= end) continue;
    return Status::invalidInput("nothing came on " + *missing() + " within " +
                                seconds(parameters_.wait) +
                                "; is the camera connected? (`rostopic hz " + *missing() + "`)");
  }
  return Status::ok();
}

Status LiveCamera::next(ArrivedPair& pair) {
  for (const std::int64_t end = deadline();;) {
    if (auto taken = queue_.take()) {
      pair = std::move(*taken);
      return Status::ok();
    }
    if (clock_.steadyNs() > end) return Status::endOfStream();
    if (Status status = pause(); !status.isOk()) return status;
  }
}

Status LiveCamera::silence() const {
  const std::string since = " for " + seconds(parameters_.wait);
  if (!node_->masterAnswers()) {
    return Status::invalidInput("no image came on " + topics_.left + since +
                                ", and the roscore at " + node_->master() +
                                " is gone; start both again, and go on with --continue");
  }
  const bool pair = !topics_.right.empty();
  for (std::size_t i = 0; i < (pair ? 2U : 1U); ++i) {
    if (subscribers_[i].getNumPublishers() > 0) continue;
    return Status::invalidInput("no image came on " + (i == 0 ? topics_.left : topics_.right) +
                                since +
                                ": nobody publishes it any more; start the camera's node again, "
                                "and go on with --continue");
  }
  return Status::invalidInput("no image came on " + topics_.left + (pair ? " with one on " : "") +
                              topics_.right + since +
                              ", though its node runs; the camera was unplugged, or hangs: connect "
                              "it again, and go on with --continue");
}

}  // namespace tolman::ros1
