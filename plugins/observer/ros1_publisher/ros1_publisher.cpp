// SPDX-License-Identifier: BSD-3-Clause
#include "ros1_publisher.hpp"

#include <cmath>

#include "map_messages.hpp"
#include "map_shapes.hpp"

namespace tolman::ros1_publisher {

Status Ros1Publisher::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  log_ = &context.log;
  clock_ = &context.clock;
  const std::string& prefix = parameters_.prefix;
  if (Status status = ros_map::checkPrefix(prefix); !status.isOk()) return status;
  auto node = ros1_node::Node::start(parameters_.master);
  if (!node.isOk()) return node.status();
  node_ = std::move(node).value();
  publishers_ = std::make_unique<Publishers>(node_->handle(), prefix, parameters_.map_frame,
                                             parameters_.camera_frame, parameters_.tf);
  return reset();
}

Status Ros1Publisher::reset() {
  has_waiting_ = false;
  map_ns_ = watch_ns_ = clock_->steadyNs();
  stamp_ns_ = 0;
  return Status::ok();
}

Status Ros1Publisher::begin(const RunInfo&) { return Status::ok(); }

Status Ros1Publisher::observe(const Snapshot& snapshot) {
  if (snapshot.map != nullptr) {
    stamp_ns_ = snapshot.map->stamp_ns;
    const Eigen::Isometry3d& T_world_camera = snapshot.map->T_world_camera;
    publishers_->publishPose(stamp_ns_, ros_map::robotPose(T_world_camera),
                             ros_map::cameraPose(T_world_camera));
  }
  if (snapshot.graph != nullptr) {
    waiting_ = *snapshot.graph;
    has_waiting_ = true;
  }
  const std::int64_t now = clock_->steadyNs();
  if (has_waiting_ && now - map_ns_ >= std::llround(parameters_.every * 1e9)) {
    publishMap(waiting_);
    map_ns_ = now;
  }
  watchMaster();
  return Status::ok();
}

Status Ros1Publisher::finish(const MapGraph& graph) {
  publishMap(graph);
  return Status::ok();
}

void Ros1Publisher::publishMap(const MapGraph& graph) {
  publishers_->publishMap(stamp_ns_, ros_map::shapesOf(graph));
  has_waiting_ = false;
}

void Ros1Publisher::watchMaster() {
  constexpr std::int64_t kIntervalNs = 2'000'000'000;
  const std::int64_t now = clock_->steadyNs();
  if (now - watch_ns_ < kIntervalNs) return;
  watch_ns_ = now;
  const bool gone = !node_->masterAnswers();
  if (gone && !master_is_gone_) {
    log_->warning("the roscore at " + node_->master() +
                  " is gone: who listens already still gets poses, and nobody else can; the run "
                  "goes on and is recorded");
  }
  master_is_gone_ = gone;
}

}  // namespace tolman::ros1_publisher
