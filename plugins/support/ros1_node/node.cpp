// SPDX-License-Identifier: BSD-3-Clause
#include "node.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <chrono>
#include <cstdlib>

#include "master_probe.hpp"

namespace tolman::ros1_node {
namespace {

constexpr std::chrono::seconds kLongestAnswer{5};

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
  if (Status status = node->askMaster(); !status.isOk()) return status;
  node->handle_ = std::make_unique<ros::NodeHandle>();
  node->handle_->setCallbackQueue(&node->queue_);
  return node;
}

Status Node::askMaster() const {
  std::string host;
  std::uint32_t port = 0;
  ros::network::splitURI(master_, host, port);
  return probeMaster(master_, host, port, kLongestAnswer);
}

std::map<std::string, std::string> Node::topics() const {
  ros::master::V_TopicInfo found;
  std::map<std::string, std::string> types;
  try {
    if (!masterAnswers() || !ros::master::getTopics(found)) return types;
  } catch (const XmlRpc::XmlRpcException&) {  // an answer of other types
    return types;
  }
  for (const ros::master::TopicInfo& topic : found) types[topic.name] = topic.datatype;
  return types;
}

}  // namespace tolman::ros1_node
