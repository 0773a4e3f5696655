// SPDX-License-Identifier: BSD-3-Clause
#include "relaxation_map.hpp"

#include <algorithm>
#include <string>

namespace tolman::relaxation {
namespace {

Eigen::Isometry3d raised(const PlanarPose& pose, double height) {
  Eigen::Isometry3d T = fromPlanar(pose);
  T.translation().y() -= height;
  return T;
}

}  // namespace

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
  climbed_ = 0;
  T_start_camera_.setIdentity();
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
  if (!frames_.empty()) advance(motion);
  applyDecision(motion, decision);
  frames_.push_back({motion.frame, current_, accumulated_, climbed_});
  update.frame = motion.frame;
  update.stamp_ns = motion.stamp_ns;
  update.experience = current_;
  update.T_world_camera = poseInWorld(frames_.back());
  update.T_experience_camera =
      current_ < 0 ? update.T_world_camera : raised(accumulated_, climbed_);
  update.version = version_;
  update.experiences = experiences_.size();
  update.links = static_cast<std::int64_t>(experiences_.links().size());
  update.loops = loops_;
  return Status::ok();
}

void RelaxationMap::advance(const Motion& motion) {
  if (!parameters_.height) {
    accumulated_ = compose(accumulated_, tolman::toPlanar(motion.T_previous_current));
    return;
  }
  const Eigen::Isometry3d before = T_start_camera_;
  T_start_camera_ = normalised(before * motion.T_previous_current);
  const PlanarPose level = between(tolman::toPlanar(before), tolman::toPlanar(T_start_camera_));
  accumulated_ = compose(accumulated_, level);
  climbed_ += before.translation().y() - T_start_camera_.translation().y();
}

void RelaxationMap::arriveAt(std::int64_t experience, const PlanarPose& offset,
                             std::int64_t stamp_ns) {
  current_ = experience;
  accumulated_ = offset;
  climbed_ = 0;
  left_ns_ = stamp_ns;  // start of the next link's duration
}

void RelaxationMap::applyDecision(const Motion& motion, const Decision& decision) {
  if (decision.action == Action::Stay) return;
  const double seconds = 1e-9 * static_cast<double>(motion.stamp_ns - left_ns_);
  if (decision.action == Action::CreateExperience) {
    const PlanarPose here =
        current_ < 0 ? accumulated_ : compose(experiences_[current_], accumulated_);
    const double height = current_ < 0 ? climbed_ : experiences_.height(current_) + climbed_;
    const std::int64_t made = experiences_.add(here, height);
    creations_.push_back({motion.frame, decision.template_id});
    if (current_ >= 0) {
      experiences_.link(current_, made, accumulated_, seconds, motion.frame, false, climbed_);
    }
    arriveAt(made, {}, motion.stamp_ns);
  } else {
    // The robot is assumed to be at the position of the old experience; only the heading is
    // measured.
    PlanarPose link = accumulated_;
    link.theta = wrapAngle(link.theta - decision.relative_yaw);
    if (experiences_.link(current_, decision.experience, link, seconds, motion.frame, true,
                          climbed_)) {
      ++loops_;
    }
    arriveAt(decision.experience, {0, 0, decision.relative_yaw}, motion.stamp_ns);
  }
  experiences_.relax(parameters_.sweeps, parameters_.correction);
  ++version_;
}

/// Relaxation also moves the first experience, so poses are given relative to the first frame, the
/// origin of the world.
Eigen::Isometry3d RelaxationMap::inWorld(const PlanarPose& pose, double height) const {
  if (experiences_.size() == 0) return raised(pose, height);
  const PlacedFrame& first = frames_.front();
  if (first.experience < 0) return raised(pose, height);
  const PlanarPose start = compose(experiences_[0], first.relative_to_experience);
  return raised(between(start, pose), height - experiences_.height(0) - first.climbed);
}

Eigen::Isometry3d RelaxationMap::poseInWorld(const PlacedFrame& placed) const {
  if (placed.experience < 0) return raised(placed.relative_to_experience, placed.climbed);
  return inWorld(compose(experiences_[placed.experience], placed.relative_to_experience),
                 experiences_.height(placed.experience) + placed.climbed);
}

Status RelaxationMap::poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const {
  const auto found = std::ranges::lower_bound(frames_, frame, {}, &PlacedFrame::frame);
  if (found == frames_.end() || found->frame != frame) {
    return Status::invalidParameter("the map has not seen frame " + std::to_string(frame));
  }
  T_world_camera = poseInWorld(*found);
  return Status::ok();
}

Status RelaxationMap::graph(MapGraph& graph) const {
  graph = {};
  graph.version = version_;
  for (std::int64_t id = 0; id < experiences_.size(); ++id) {
    const Creation& creation = creations_[static_cast<std::size_t>(id)];
    graph.experiences.push_back({id, creation.frame, creation.template_id,
                                 inWorld(experiences_[id], experiences_.height(id))});
  }
  for (const PolarLink& polar : experiences_.links()) {
    Link link;
    link.id = static_cast<std::int64_t>(graph.links.size());
    link.from = polar.from;
    link.to = polar.to;
    link.kind = polar.loop ? LinkKind::Loop : LinkKind::Odometry;
    link.frame = polar.frame;
    link.T_from_to = raised(toPlanar(polar), polar.climb);
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
