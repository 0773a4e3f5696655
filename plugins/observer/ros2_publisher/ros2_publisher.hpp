// SPDX-License-Identifier: BSD-3-Clause
// Observer `ros2_publisher`: odometry, transforms, map and state of a run as topics of ROS 2.
#pragma once

#include <memory>
#include <optional>

#include "map_messages.hpp"
#include "node.hpp"
#include "publisher_parameters.hpp"
#include "tolman/roles.hpp"

namespace tolman::ros2_publisher {

class Ros2Publisher final : public Observer {
 public:
  using Parameters = PublisherParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status begin(const RunInfo& run) override;
  Status observe(const Snapshot& snapshot) override;
  Status finish(const MapGraph& graph) override;

 private:
  /// The topics, advertised.
  struct Topics {
    ros2_node::Writer odometry, tf, path, map, diagnostics;
  };
  Result<Topics> advertise();
  void publishOdometry(const Snapshot& snapshot);
  void publishMap(const MapGraph& graph);
  void publishState(const Snapshot& snapshot);
  /// Warns once if messages cannot be sent.
  void send(const ros2_node::Writer& writer, const ros_map::FieldWriter& message);

  Parameters parameters_;
  Logger* log_ = nullptr;
  const Clock* clock_ = nullptr;
  std::unique_ptr<ros2_node::Node> node_;
  std::optional<Topics> topics_;
  std::string run_;                  ///< name
  std::optional<MapGraph> waiting_;  ///< the newest map that is not published yet
  std::optional<ros_map::RunFrames> frames_;
  std::int64_t map_ns_ = 0;    ///< clock time at which a map was last published
  std::int64_t state_ns_ = 0;  ///< and a state
  std::int64_t stamp_ns_ = 0;  ///< of the last frame
  std::int64_t unsent_ = 0;    ///< messages
};

}  // namespace tolman::ros2_publisher
