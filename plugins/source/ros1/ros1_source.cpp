// SPDX-License-Identifier: BSD-3-Clause
#include "ros1_source.hpp"

#include <ros/subscriber.h>

#include "node.hpp"
#include "raw_message.hpp"

namespace tolman::ros1 {
namespace {

class Ros1Transport final : public live_images::Transport {
 public:
  explicit Ros1Transport(std::unique_ptr<ros1_node::Node> node) : node_(std::move(node)) {}

  std::string name() const override { return "ROS 1"; }
  std::string command() const override { return "rostopic"; }
  ros_messages::Encoding encoding() const override { return ros_messages::Encoding::Ros1; }
  std::map<std::string, std::string> topics() const override { return node_->topics(); }

  Status subscribe(const std::string& topic, const std::string&,
                   std::function<void(live_images::Bytes)> handle) override {
    using Raw = boost::shared_ptr<const ros1_node::RawMessage>;
    constexpr std::uint32_t kQueued = 100;  // messages that roscpp keeps for a topic
    const boost::function<void(const Raw&)> callback = [handle](const Raw& raw) {
      handle(raw->bytes);
    };
    subscribers_[topic] =
        node_->handle().subscribe<ros1_node::RawMessage>(topic, kQueued, callback);
    return Status::ok();
  }
  void process() override { node_->queue().callAvailable(ros::WallDuration(0.02)); }

  std::size_t publishers(const std::string& topic) const override {
    return subscribers_.at(topic).getNumPublishers();
  }
  std::string outage() const override {
    if (node_->masterAnswers()) return "";
    return ", and the roscore at " + node_->master() + " is gone";
  }
  std::string hang() const override {
    return ", though its node runs; the camera was unplugged, or hangs: connect it again";
  }

 private:
  std::unique_ptr<ros1_node::Node> node_;
  std::map<std::string, ros::Subscriber> subscribers_;  ///< destroyed before the node
};

}  // namespace

Status Ros1Source::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return begin(bound.status(), {}, context);
  auto node = ros1_node::Node::start(bound.value().master);
  if (!node.isOk()) return begin(node.status(), bound.value(), context);
  std::unique_ptr<live_images::Transport> transport =
      std::make_unique<Ros1Transport>(std::move(node).value());
  return begin(std::move(transport), bound.value(), context);
}

}  // namespace tolman::ros1
