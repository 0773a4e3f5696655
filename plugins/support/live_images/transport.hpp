// SPDX-License-Identifier: BSD-3-Clause
// What a source of live images needs of ROS 1 or ROS 2.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "messages.hpp"
#include "tolman/status.hpp"

namespace tolman::live_images {

using ros_messages::Bytes;

class Transport {
 public:
  virtual ~Transport() = default;

  /// "ROS 1", and its command that lists topics.
  virtual std::string name() const = 0;
  virtual std::string command() const = 0;
  virtual ros_messages::Encoding encoding() const = 0;
  /// What others publish now: types by the names of topics.
  virtual std::map<std::string, std::string> topics() const = 0;
  /// `handle` is called by process(), with bytes that are valid during the call.
  virtual Status subscribe(const std::string& topic, const std::string& type,
                           std::function<void(Bytes)> handle) = 0;
  /// Waits a moment for messages, and hands out those that have come.
  virtual void process() = 0;
  /// Number of publishers of a topic that this process subscribes to.
  virtual std::size_t publishers(const std::string& topic) const = 0;
  /// Messages of the topic that were lost on the way, as far as that is known.
  virtual std::size_t lost(const std::string& /*topic*/) const { return 0; }
  /// Why nothing comes at all, as ", and the roscore is gone"; or empty.
  virtual std::string outage() const { return ""; }
  /// Why a topic that is published may be silent, as ", though ...".
  virtual std::string hang() const = 0;
  /// Why a published topic never sent anything; or empty.
  virtual std::string misfit(const std::string& /*topic*/) const { return ""; }
};

}  // namespace tolman::live_images
