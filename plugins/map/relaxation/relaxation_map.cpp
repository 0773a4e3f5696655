// SPDX-License-Identifier: BSD-3-Clause
#include "relaxation_map.hpp"

#include <algorithm>
#include <string>

namespace tolman::relaxation {

Status RelaxationMap::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  return reset();
}

Status RelaxationMap::reset() {
  experiences_ = {};
  creations_.clear();
  frames_.clear();
  current_ = -1;
  accumulated_ = {};
  left_ns_ = 0;
  loops_ = 0;
  version_ = 0;
  return Status::ok();
}

Status RelaxationMap::check(const Motion& motion, const Decision& decision) const {
  if (!frames_.empty() && motion.frame <= frames_.back().frame) {
    return Status::invalidInput(
        "motion of frame " + std::to_string(motion.frame) + " comes after that of frame " +
        std::to_string(frames_.back().frame) + "; frames must come in order");
  }
  if (decision.frame != motion.frame) {
    return Status::invalidInput("the decision is of frame " + std::to_string(decision.frame) +
                                ", but the motion of frame " + std::to_string(motion.frame));
  }
  const std::int64_t known = experiences_.size();
  const bool creates = decision.action == Action::CreateExperience;
  const std::int64_t least = decision.action == Action::CloseLoop ? 0 : -1;
  const bool fits = creates ? decision.experience == known
                            : decision.experience >= least && decision.experience < known;
  if (fits) return Status::ok();
  return Status::invalidInput("the decision (" + std::string(enumName(decision.action)) +
                              ") names experience " + std::to_string(decision.experience) +
                              ", but there are " + std::to_string(known));
}

Status RelaxationMap::update(const Motion& motion, const Decision& decision, MapUpdate& update) {
  if (Status status = check(motion, decision); !status.isOk()) return status;
  if (!frames_.empty()) {
    accumulated_ = compose(accumulated_, tolman::toPlanar(motion.T_previous_current));
  }
  applyDecision(motion, decision);
  frames_.push_back({motion.frame, current_, accumulated_});
  update.frame = motion.frame;
  update.stamp_ns = motion.stamp_ns;
  update.experience = current_;
  update.T_world_camera = fromPlanar(poseInWorld(frames_.back()));
  update.T_experience_camera = current_ < 0 ? update.T_world_camera : fromPlanar(accumulated_);
  update.version = version_;
  update.experiences = experiences_.size();
  update.links = static_cast<std::int64_t>(experiences_.links().size());
  update.loops = loops_;
  return Status::ok();
}

void RelaxationMap::arriveAt(std::int64_t experience, const PlanarPose& offset,
                             std::int64_t stamp_ns) {
  current_ = experience;
  accumulated_ = offset;
  left_ns_ = stamp_ns;  // start of the next link's duration
}

void RelaxationMap::applyDecision(const Motion& motion, const Decision& decision) {
  if (decision.action == Action::Stay) return;
  const double seconds = 1e-9 * static_cast<double>(motion.stamp_ns - left_ns_);
  if (decision.action == Action::CreateExperience) {
    const PlanarPose here =
        current_ < 0 ? accumulated_ : compose(experiences_[current_], accumulated_);
    const std::int64_t made = experiences_.add(here);
    creations_.push_back({motion.frame, decision.template_id});
    if (current_ >= 0) {
      experiences_.link(current_, made, accumulated_, seconds, motion.frame, false);
    }
    arriveAt(made, {}, motion.stamp_ns);
  } else {
    // The robot's position becomes that of the old experience; only the heading is measured.
    PlanarPose link = accumulated_;
    link.theta = wrapAngle(link.theta - decision.relative_yaw);
    if (experiences_.link(current_, decision.experience, link, seconds, motion.frame, true)) {
      ++loops_;
    }
    arriveAt(decision.experience, {0, 0, decision.relative_yaw}, motion.stamp_ns);
  }
  experiences_.relax(parameters_.sweeps, parameters_.correction);
  ++version_;
}

/// Relaxation moves every experience; the first frame is the origin of the world.
PlanarPose RelaxationMap::inWorld(const PlanarPose& pose) const {
  if (experiences_.size() == 0) return pose;
  const PlacedFrame& first = frames_.front();
  const PlanarPose start =
      first.experience < 0 ? PlanarPose{} : compose(experiences_[0], first.relative_to_experience);
  return between(start, pose);
}

PlanarPose RelaxationMap::poseInWorld(const PlacedFrame& placed) const {
  if (placed.experience < 0) return placed.relative_to_experience;
  return inWorld(compose(experiences_[placed.experience], placed.relative_to_experience));
}

Status RelaxationMap::poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const {
  const auto found = std::ranges::lower_bound(frames_, frame, {}, &PlacedFrame::frame);
  if (found == frames_.end() || found->frame != frame) {
    return Status::invalidParameter("the map has not seen frame " + std::to_string(frame));
  }
  T_world_camera = fromPlanar(poseInWorld(*found));
  return Status::ok();
}

Status RelaxationMap::graph(MapGraph& graph) const {
  graph = {};
  graph.version = version_;
  for (std::int64_t id = 0; id < experiences_.size(); ++id) {
    const Creation& creation = creations_[static_cast<std::size_t>(id)];
    graph.experiences.push_back(
        {id, creation.frame, creation.template_id, fromPlanar(inWorld(experiences_[id]))});
  }
  for (const PolarLink& polar : experiences_.links()) {
    Link link;
    link.id = static_cast<std::int64_t>(graph.links.size());
    link.from = polar.from;
    link.to = polar.to;
    link.kind = polar.loop ? LinkKind::Loop : LinkKind::Odometry;
    link.frame = polar.frame;
    link.T_from_to = fromPlanar(toPlanar(polar));
    link.covariance = Matrix6d::Identity();  // all links have equal weight
    link.duration = polar.loop ? 0 : polar.seconds;
    graph.links.push_back(link);
  }
  return Status::ok();
}

/// RatSLAM has no revisions, and every decision has relaxed the map already.
Status RelaxationMap::finish(const std::vector<MotionRevision>& /*revisions*/) {
  return Status::ok();
}

}  // namespace tolman::relaxation
