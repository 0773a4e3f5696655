// SPDX-License-Identifier: BSD-3-Clause
// Observer `ros1_publisher`: pose, path, transform and map of a run as topics of ROS 1.
#pragma once

#include <memory>

#include "node.hpp"
#include "publisher_parameters.hpp"
#include "publishers.hpp"
#include "tolman/roles.hpp"

namespace tolman::ros1_publisher {

class Ros1Publisher final : public Observer {
 public:
  using Parameters = PublisherParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status begin(const RunInfo& run) override;
  Status observe(const Snapshot& snapshot) override;
  Status finish(const MapGraph& graph) override;

 private:
  void publishMap(const MapGraph& graph);
  /// Warns once when the roscore does not answer; present subscribers still receive messages.
  void watchMaster();

  Parameters parameters_;
  Logger* log_ = nullptr;
  const Clock* clock_ = nullptr;
  std::unique_ptr<ros1_node::Node> node_;
  std::unique_ptr<Publishers> publishers_;  ///< destroyed before the node
  MapGraph waiting_;                        ///< the newest map that is not published yet
  bool has_waiting_ = false;
  std::int64_t map_ns_ = 0;    ///< clock time at which a map was last published
  std::int64_t watch_ns_ = 0;  ///< clock time of the last check of the roscore
  std::int64_t stamp_ns_ = 0;  ///< of the last frame
  bool master_is_gone_ = false;
};

}  // namespace tolman::ros1_publisher
