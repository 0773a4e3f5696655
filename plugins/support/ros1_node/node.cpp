// SPDX-License-Identifier: BSD-3-Clause
#include "node.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>

#include <cstdlib>

namespace tolman::ros1_node {
namespace {

constexpr const char* kRemedy = "; start it (`roscore`), or set master to where it is";

std::string uriOf(const std::string& master) {
  if (!master.empty()) return master;
  const char* set = std::getenv("ROS_MASTER_URI");
  return set != nullptr && *set != '\0' ? set : "http://localhost:11311";
}

/// Starts roscpp. It ends the process for a malformed or missing URI, so the URI is checked first.
Status initialise(const std::string& master) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(master, host, port) || host.empty()) {
    return Status::invalidParameter("'" + master +
                                    "' is no URI of a roscore; write http://host:11311");
  }
  // Errors are reported by the plugins.
  ros::console::set_logger_level(ROSCONSOLE_ROOT_LOGGER_NAME, ros::console::levels::Fatal);
  ros::console::notifyLoggerLevelsChanged();
  using namespace ros::init_options;
  ros::init(ros::M_string{{"__master", master}}, "tolman",
            NoSigintHandler | AnonymousName | NoRosout);
  ros::master::setRetryTimeout(ros::WallDuration(1.0));
  if (ros::master::getURI() == master) return Status::ok();
  return Status::unsupported("this process talks to the roscore at " + ros::master::getURI() +
                             ", and cannot talk to that at " + master +
                             ", too; give all plugins ros1 one master");
}

}  // namespace

Result<std::unique_ptr<Node>> Node::start(const std::string& master) {
  std::unique_ptr<Node> node(new Node(uriOf(master)));
  if (Status status = initialise(node->master_); !status.isOk()) return status;
  if (!node->masterAnswers()) {
    return Status::invalidInput("no roscore answers at " + node->master_ + kRemedy);
  }
  node->handle_ = std::make_unique<ros::NodeHandle>();
  node->handle_->setCallbackQueue(&node->queue_);
  return node;
}

bool Node::masterAnswers() const { return ros::master::check(); }

std::map<std::string, std::string> Node::topics() const {
  ros::master::V_TopicInfo found;
  std::map<std::string, std::string> types;
  if (!masterAnswers() || !ros::master::getTopics(found)) return types;
  for (const ros::master::TopicInfo& topic : found) types[topic.name] = topic.datatype;
  return types;
}

}  // namespace tolman::ros1_node
