// SPDX-License-Identifier: BSD-3-Clause
#include "ros2_source.hpp"

#include "node.hpp"

namespace tolman::ros2 {
namespace {

class Ros2Transport final : public live_images::Transport {
 public:
  Ros2Transport(std::unique_ptr<ros2_node::Node> node, bool reliable)
      : node_(std::move(node)), reliable_(reliable) {}

  std::string name() const override { return "ROS 2"; }
  std::string command() const override { return "ros2 topic"; }
  ros_messages::Encoding encoding() const override { return ros_messages::Encoding::Cdr; }
  std::map<std::string, std::string> topics() const override {
    std::map<std::string, std::string> types;
    for (const auto& [topic, offer] : node_->offers()) types[topic] = offer.type;
    return types;
  }

  /// What a publisher keeps for later subscribers, as often a CameraInfo, is asked for.
  Status subscribe(const std::string& topic, const std::string& type,
                   std::function<void(live_images::Bytes)> handle) override {
    constexpr int kQueued = 100;  // messages that wait to be taken
    const auto offers = node_->offers();
    const auto offer = offers.find(topic);
    const bool is_kept = offer != offers.end() && offer->second.kept && offer->second.reliable;
    const auto reader = node_->subscribe(topic, type, {reliable_ || is_kept, is_kept, kQueued});
    if (!reader.isOk()) return reader.status();
    subscribers_.insert_or_assign(topic, Subscriber{reader.value(), std::move(handle)});
    return Status::ok();
  }
  void process() override {
    constexpr std::int64_t kLongest_ns = 20'000'000;
    node_->wait(kLongest_ns);
    for (auto& [topic, subscriber] : subscribers_) subscriber.reader.take(subscriber.handle);
  }

  std::size_t publishers(const std::string& topic) const override {
    return subscribers_.at(topic).reader.publishers();
  }
  std::size_t lost(const std::string& topic) const override {
    return subscribers_.at(topic).reader.lost();
  }
  std::string hang() const override {
    return ", and its node has not signed off: it was killed, or hangs, or the camera was "
           "unplugged; start it again";
  }
  std::string misfit(const std::string& topic) const override {
    if (!reliable_ || !subscribers_.at(topic).reader.hasUnfit()) return "";
    return ": its publisher does not send reliably; leave out reliable";
  }

 private:
  struct Subscriber {
    ros2_node::Reader reader;
    std::function<void(live_images::Bytes)> handle;
  };

  std::unique_ptr<ros2_node::Node> node_;
  bool reliable_;
  std::map<std::string, Subscriber> subscribers_;
};

}  // namespace

Status Ros2Source::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return begin(bound.status(), {}, context);
  auto node = ros2_node::Node::start(bound.value());
  if (!node.isOk()) return begin(node.status(), bound.value(), context);
  std::unique_ptr<live_images::Transport> transport =
      std::make_unique<Ros2Transport>(std::move(node).value(), bound.value().reliable);
  return begin(std::move(transport), bound.value(), context);
}

}  // namespace tolman::ros2
