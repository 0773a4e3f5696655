// SPDX-License-Identifier: BSD-3-Clause
// One camera or a pair as topics of a roscore: received images, and the reason if none come.
#pragma once

#include <ros/subscriber.h>

#include <memory>
#include <string>
#include <vector>

#include "live_topics.hpp"
#include "messages.hpp"
#include "node.hpp"
#include "pair_queue.hpp"
#include "ros1_parameters.hpp"
#include "tolman/context.hpp"

namespace tolman::ros1 {

class LiveCamera {
 public:
  /// Waits for the topics, and then for the first image of each camera and its CameraInfo.
  static Result<std::unique_ptr<LiveCamera>> open(const Ros1Parameters& parameters,
                                                  const Context& context);

  const LiveTopics& topics() const { return topics_; }
  /// Message types in the notation of ROS 2.
  const std::string& leftType() const { return left_type_; }
  const std::string& rightType() const { return right_type_; }
  /// The last CameraInfo; empty without a topic for it.
  const std::vector<std::uint8_t>& leftInfo() const { return left_info_; }
  const std::vector<std::uint8_t>& rightInfo() const { return right_info_; }
  /// The first image of the left camera, which next() also returns.
  const std::vector<std::uint8_t>& firstLeft() const { return first_left_; }

  /// Waits for the next image or pair. EndOfStream: none came within the time `wait`; silence() has
  /// the reason. Cancelled: the run is to end.
  Status next(ArrivedPair& pair);
  /// The reason why no images come: there is no roscore, no publisher, or the camera sends nothing.
  Status silence() const;
  std::size_t leftOut() const { return queue_.leftOut(); }

 private:
  LiveCamera(const Ros1Parameters& parameters, const Context& context)
      : parameters_(parameters), clock_(context.clock), cancellation_(context.cancellation) {}
  Status findTopics();
  void subscribe();
  Status waitForFirst();
  /// Processes arriving messages for a short time.
  Status pause();
  std::int64_t deadline() const;

  Ros1Parameters parameters_;
  const Clock& clock_;
  const Cancellation& cancellation_;
  std::unique_ptr<ros1_node::Node> node_;
  LiveTopics topics_;
  std::string left_type_;
  std::string right_type_;
  PairQueue queue_;
  std::vector<std::uint8_t> first_left_;
  std::vector<std::uint8_t> left_info_;
  std::vector<std::uint8_t> right_info_;
  std::vector<ros::Subscriber> subscribers_;  ///< images first; destroyed before the node
};

}  // namespace tolman::ros1
