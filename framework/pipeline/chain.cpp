// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/chain.hpp"

#include <algorithm>

#include "pipeline/undisturbed.hpp"
#include "plugins/prediction.hpp"

namespace tolman::pipeline {
namespace {

// Of a graph this large, every frame may have a copy; of a larger one, frames in proportion fewer.
constexpr std::size_t kGraphSizePerFrame = 400;  // experiences and links

/// The stand-in answer of a skipped odometry.
Motion predictedMotion(const Frame& frame, const Motion& last) {
  Motion motion;
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  if (last.frame < 0) return motion;  // nothing leads to the first frame
  motion.scale_known = last.scale_known;
  plugins::predict(motion, last, static_cast<double>(frame.stamp_ns - last.stamp_ns) * 1e-9);
  return motion;
}

}  // namespace

std::optional<Status> Chain::failure() const {
  const std::lock_guard lock(failure_mutex_);
  return failure_;
}

void Chain::fail(const Status& status) {
  const std::lock_guard lock(failure_mutex_);
  if (!failure_) failure_ = status;
}

void Chain::failInput(const Status& status) {
  listener_.onEvent({-1, LogLevel::Error, "source", status.message()});
  const std::lock_guard lock(failure_mutex_);
  input_failure_ = status;
}

Status Chain::result() const {
  const std::lock_guard lock(failure_mutex_);
  return failure_.value_or(input_failure_.value_or(Status::ok()));
}

bool Chain::resolve(const Status& status, config::FailurePolicy policy, std::int64_t frame,
                    std::string_view role) {
  if (status.isOk()) return true;
  if (policy == config::FailurePolicy::Stop) {
    listener_.onEvent({frame, LogLevel::Error, std::string(role), status.message()});
    fail(status);
    return false;
  }
  ++counters_.skipped;
  const FailureTally::Tell tell = failures_.count(role);
  if (tell == FailureTally::Tell::No) return true;
  const char* last = tell == FailureTally::Tell::LastTime ? "; more are counted, not told" : "";
  listener_.onEvent({frame, LogLevel::Warning, std::string(role),
                     status.message() + (frame < 0 ? "; going on" : "; frame skipped") + last});
  return true;
}

void Chain::admit(Packet& packet) {
  packet.sequence = admitted_++;
  ++place_backlog_;
}

void Chain::odometry(Packet& packet) {
  if (failed()) return;
  const StageTimer timer(packet.times, Role::Odometry);
  packet.odometry_status =
      undisturbed([&] { return stages_.odometry.track(packet.frame, packet.motion); });
}

void Chain::place(Packet& packet) {
  --place_backlog_;
  if (failed()) return;
  packet.place.frame = packet.frame.frame;
  packet.place.stamp_ns = packet.frame.stamp_ns;
  if (packet.leave_out_place) return;
  const StageTimer timer(packet.times, Role::Place);
  const Motion* motion = place_needs_motion_ ? &packet.motion : nullptr;
  packet.place_status =
      undisturbed([&] { return stages_.place.observe(packet.frame, motion, packet.place); });
}

bool Chain::takeOdometry(Packet& packet) {
  const Status& status = packet.odometry_status;
  if (!resolve(status, policies_.odometry, packet.frame.frame, "odometry")) return false;
  if (!status.isOk()) packet.motion = predictedMotion(packet.frame, last_motion_);
  last_motion_ = packet.motion;
  return true;
}

bool Chain::takePlace(Packet& packet) {
  const Status& status = packet.place_status;
  if (!resolve(status, policies_.place, packet.frame.frame, "place")) return false;
  if (status.isOk()) return true;
  packet.place = PlaceObservation{};
  packet.place.frame = packet.frame.frame;
  packet.place.stamp_ns = packet.frame.stamp_ns;
  return true;
}

bool Chain::decide(Packet& packet) {
  Status status;
  Status arrays;
  {
    const StageTimer timer(packet.times, Role::Cells);
    status = stages_.cells.step(packet.motion, packet.place, packet.decision);
    if (status.isOk()) {
      arrays = stages_.cells.instance().arrays(packet.frame.frame, packet.cells);
    }
  }
  if (!resolve(status, policies_.cells, packet.frame.frame, "cells")) return false;
  // A decision that was taken stands, whatever becomes of the pictures.
  if (!resolve(arrays, policies_.cells, packet.frame.frame, "cells")) return false;
  if (!arrays.isOk()) packet.cells.clear();
  if (!status.isOk()) {
    packet.decision = Decision{};
    packet.decision.frame = packet.frame.frame;
    packet.decision.stamp_ns = packet.frame.stamp_ns;
    packet.decision.experience = last_decision_.experience;
    packet.decision.heading = last_decision_.heading;
  }
  last_decision_ = packet.decision;
  return true;
}

bool Chain::map(Packet& packet) {
  Status status;
  {
    const StageTimer timer(packet.times, Role::Map);
    status = stages_.map.update(packet.motion, packet.decision, packet.map);
  }
  if (!resolve(status, policies_.map, packet.frame.frame, "map")) return false;
  if (!status.isOk()) {  // hang the frame where the last one hung, moved by the motion
    const Eigen::Isometry3d& step = packet.motion.T_previous_current;
    packet.map = last_map_;
    packet.map.frame = packet.frame.frame;
    packet.map.stamp_ns = packet.frame.stamp_ns;
    packet.map.T_experience_camera = last_map_.T_experience_camera * step;
    packet.map.T_world_camera = last_map_.T_world_camera * step;
  }
  publishGraph(packet);
  last_map_ = packet.map;
  return true;
}

/// The recorder wants every change, and an odometry that revises its last motions changes the map
/// at every frame. But to copy, check and store a graph costs time in proportion to its size:
/// waiting in proportion, too, bounds the cost of a frame however long the run. What waits is
/// published later, at the latest by finish().
void Chain::publishGraph(Packet& packet) {
  const MapUpdate& now = packet.map;
  graph_is_news_ = graph_is_news_ || now.version != last_map_.version ||
                   now.experiences != last_map_.experiences || now.links != last_map_.links;
  if (!graph_is_news_ || now.frame < next_graph_frame_) return;
  graph_is_news_ = false;
  const Status status = stages_.map.graph(packet.graph);
  packet.graph_changed = resolve(status, policies_.map, now.frame, "map") && status.isOk();
  const std::size_t size = packet.graph.experiences.size() + packet.graph.links.size();
  next_graph_frame_ = now.frame + 1 + static_cast<std::int64_t>(size / kGraphSizePerFrame);
}

void Chain::think(Packet& packet) {
  if (failed()) return;
  packet.answered =
      takeOdometry(packet) && takePlace(packet) && decide(packet) && map(packet) && !failed();
  if (packet.answered) count(packet);
}

void Chain::count(const Packet& packet) {
  ++counters_.frames;
  if (!packet.frame.defect.empty()) ++counters_.defects;
  const bool lost = packet.motion.state == TrackingState::Lost;
  if (lost) ++counters_.lost;
  if (lost != counters_.lost_at_end) {
    listener_.onEvent({packet.frame.frame, lost ? LogLevel::Warning : LogLevel::Info, "odometry",
                       lost ? "tracking lost; motion is predicted" : "tracking again"});
  }
  counters_.lost_at_end = lost;
  if (packet.leave_out_place) ++counters_.place_left_out;
  counters_.templates = std::max(counters_.templates, packet.place.template_id + 1);
  counters_.experiences = packet.map.experiences;
  counters_.links = packet.map.links;
  counters_.loops = packet.map.loops;
}

void Chain::tell(const Packet& packet) {
  if (!packet.answered) return;
  const Status status = listener_.onFrame(packet.snapshot());
  if (!status.isOk()) fail(status);
}

/// A map that takes a loop back moves frames that hang on it: only it knows where to.
void Chain::tellTrajectory() {
  std::vector<FramePose> poses;
  for (std::int64_t frame = 0; frame <= last_map_.frame; ++frame) {
    FramePose pose{frame, Eigen::Isometry3d::Identity()};
    const Status status = stages_.map.poseOf(frame, pose.T_world_camera);
    if (status.isOk()) poses.push_back(pose);
    if (!status.isOk() && status.code() != StatusCode::InvalidParameter) break;  // not just unseen
  }
  const Status told = listener_.onTrajectory(poses);
  if (!told.isOk()) fail(told);
}

void Chain::finish() {
  std::vector<MotionRevision> revisions;
  MapGraph graph;
  const auto step = [&](Role role, config::FailurePolicy policy, const auto& work) {
    Status status;
    {
      const StageTimer timer(finish_times_ns_, role);
      status = work();
    }
    (void)resolve(status, policy, -1, enumName(role));
    return status.isOk();
  };
  step(Role::Odometry, policies_.odometry, [&] { return stages_.odometry.finish(revisions); });
  step(Role::Place, policies_.place, [&] { return stages_.place.finish(); });
  step(Role::Cells, policies_.cells, [&] { return stages_.cells.finish(); });
  std::erase_if(revisions, [&](const MotionRevision& r) { return r.frame > last_map_.frame; });
  step(Role::Map, policies_.map, [&] { return stages_.map.finish(revisions); });
  tellTrajectory();
  const bool known = step(Role::Map, policies_.map, [&] { return stages_.map.graph(graph); });
  if (!known) {
    if (policies_.map == config::FailurePolicy::Stop) return;
    graph = MapGraph();  // what was published stays; the others still hear of the end
  }
  const Status told = listener_.onFinish(revisions, graph);
  if (!told.isOk()) fail(told);
}

}  // namespace tolman::pipeline
