// SPDX-License-Identifier: BSD-3-Clause
#include "ros2_publisher.hpp"

#include <cmath>
#include <numeric>

#include "map_shapes.hpp"
#include "tolman/geometry.hpp"

namespace tolman::ros2_publisher {
namespace {

using ros_map::FieldWriter;

/// Velocities of the camera in its axes of ROS (x forward, y left, z up).
std::array<double, 6> twistOf(const Motion& motion) {
  if (!(motion.dt > 0)) return {};
  const Vector6d step = logSe3(motion.T_previous_current) / motion.dt;
  return {step[2], -step[0], -step[1], step[5], -step[3], -step[4]};
}

}  // namespace

Status Ros2Publisher::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  log_ = &context.log;
  clock_ = &context.clock;
  if (Status status = ros_map::checkPrefix(parameters_.prefix); !status.isOk()) return status;
  auto node = ros2_node::Node::start(parameters_);
  if (!node.isOk()) return node.status();
  node_ = std::move(node).value();
  const Result<Topics> topics = advertise();
  if (!topics.isOk()) return topics.status();
  topics_ = topics.value();
  return reset();
}

Result<Ros2Publisher::Topics> Ros2Publisher::advertise() {
  Status status;
  const auto topic = [&](const std::string& name, const char* type, ros2_node::Delivery delivery) {
    const auto writer = node_->advertise(name, type, delivery);
    if (!writer.isOk()) status = writer.status();
    return writer.isOk() ? writer.value() : ros2_node::Writer(0, nullptr);
  };
  constexpr int kSent = 100;  // messages that wait for a slow subscriber
  const std::string& prefix = parameters_.prefix;
  const Topics topics{
      topic(prefix + "/odometry", "nav_msgs/msg/Odometry", {true, false, kSent}),
      topic("/tf", "tf2_msgs/msg/TFMessage", {true, false, kSent}),
      topic(prefix + "/path", "nav_msgs/msg/Path", {true, true, 1}),
      topic(prefix + "/map", "visualization_msgs/msg/MarkerArray", {true, true, 1}),
      topic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", {true, false, kSent})};
  if (!status.isOk()) return status;
  return topics;
}

Status Ros2Publisher::reset() {
  waiting_.reset();
  frames_.emplace(parameters_.map_frame, parameters_.odom_frame, parameters_.camera_frame);
  map_ns_ = state_ns_ = clock_->steadyNs();
  stamp_ns_ = 0;
  return Status::ok();
}

Status Ros2Publisher::begin(const RunInfo& run) {
  run_ = run.name;
  return Status::ok();
}

Status Ros2Publisher::observe(const Snapshot& snapshot) {
  stamp_ns_ = snapshot.map->stamp_ns;
  publishOdometry(snapshot);
  if (snapshot.graph != nullptr) waiting_ = *snapshot.graph;
  const std::int64_t now = clock_->steadyNs();
  const std::int64_t interval_ns = std::llround(parameters_.every * 1e9);
  if (waiting_ && now - map_ns_ >= interval_ns) {
    publishMap(*waiting_);
    map_ns_ = now;
  }
  if (now - state_ns_ >= interval_ns) {
    publishState(snapshot);
    state_ns_ = now;
  }
  return Status::ok();
}

Status Ros2Publisher::finish(const MapGraph& graph) {
  publishMap(graph);
  return Status::ok();
}

void Ros2Publisher::publishOdometry(const Snapshot& snapshot) {
  frames_->add(*snapshot.motion);
  FieldWriter odometry;
  ros_map::writeOdometry(odometry, stamp_ns_, frames_->inOdom(), twistOf(*snapshot.motion));
  send(topics_->odometry, odometry);
  if (!parameters_.tf) return;
  FieldWriter transforms;
  ros_map::writeTransforms(transforms, stamp_ns_, frames_->all(snapshot.map->T_world_camera));
  send(topics_->tf, transforms);
}

void Ros2Publisher::publishMap(const MapGraph& graph) {
  const ros_map::MapShapes shapes = ros_map::shapesOf(graph);
  FieldWriter path;
  ros_map::writePath(path, stamp_ns_, parameters_.map_frame, shapes.path);
  send(topics_->path, path);
  FieldWriter markers;
  ros_map::writeMarkers(markers, stamp_ns_, parameters_.map_frame, shapes);
  send(topics_->map, markers);
  waiting_.reset();
}

void Ros2Publisher::publishState(const Snapshot& snapshot) {
  const bool is_lost = snapshot.motion->state == TrackingState::Lost;
  const std::int64_t spent_ns = std::accumulate(snapshot.stage_times_ns.begin(),
                                                snapshot.stage_times_ns.end(), std::int64_t{0});
  FieldWriter diagnostics;
  ros_map::writeDiagnosis(diagnostics, stamp_ns_,
                          {static_cast<std::uint8_t>(is_lost ? 1 : 0),
                           "tolman: " + run_,
                           std::string(enumName(snapshot.motion->state)),
                           {{"frame", std::to_string(snapshot.frame->frame)},
                            {"experiences", std::to_string(snapshot.map->experiences)},
                            {"loops", std::to_string(snapshot.map->loops)},
                            {"milliseconds", std::to_string(spent_ns / 1'000'000)}}});
  send(topics_->diagnostics, diagnostics);
}

void Ros2Publisher::send(const ros2_node::Writer& writer, const FieldWriter& message) {
  const Status status = writer.write(message.message());
  if (status.isOk() || unsent_++ > 0) return;
  log_->warning("a message is left out, " + status.message() + "; the run goes on and is recorded");
}

}  // namespace tolman::ros2_publisher
