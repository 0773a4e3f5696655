// SPDX-License-Identifier: BSD-3-Clause
// This process as a node of ROS 1 (roscpp). A process can have only one: all plugins share it and
// use the same roscore. It ends with the last plugin.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <map>
#include <memory>
#include <string>

#include "tolman/status.hpp"

namespace tolman::ros1_node {

class Node {
 public:
  /// `master`: URI of the roscore; empty: $ROS_MASTER_URI, or http://localhost:11311.
  /// InvalidInput if no roscore answers, InvalidParameter if it is not a URI.
  static Result<std::unique_ptr<Node>> start(const std::string& master);

  /// Callbacks of its subscribers run only in the thread that processes queue().
  ros::NodeHandle& handle() { return *handle_; }
  ros::CallbackQueue& queue() { return queue_; }
  const std::string& master() const { return master_; }
  /// Whether the roscore answers now, within 5 s.
  bool masterAnswers() const { return askMaster().isOk(); }
  /// Published topics with their types ("sensor_msgs/Image"); empty if the roscore does not answer.
  std::map<std::string, std::string> topics() const;

 private:
  explicit Node(std::string master) : master_(std::move(master)) {}
  Status askMaster() const;

  std::string master_;
  ros::CallbackQueue queue_;
  std::unique_ptr<ros::NodeHandle> handle_;
};

}  // namespace tolman::ros1_node
