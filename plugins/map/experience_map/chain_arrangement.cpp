// SPDX-License-Identifier: BSD-3-Clause
// Relative poses of the parts of a path with gaps. Least squares refines an arrangement of the
// parts, but it needs a start near the minimum: each loop between two parts proposes one, and the
// arrangement with the least energy is kept.
#include <algorithm>
#include <cmath>
#include <utility>

#include "experience_chain.hpp"

namespace tolman::experience_map {
namespace {

/// A loop with a smaller residual after two parts were aligned starts with full weight: the
/// residual may come from drift within the parts, which is not yet corrected.
constexpr double kNearTranslation = 20;  // m
constexpr double kNearRotation = 0.5;    // rad

bool isNear(const PlanarLink& link, const std::vector<PlanarPose>& nodes) {
  const Eigen::Vector3d off = residualOf(link, nodes[link.from], nodes[link.to]);
  return off.head<2>().norm() < kNearTranslation && std::abs(off.z()) < kNearRotation;
}

/// The motion of the plane that moves `from` to `to`.
PlanarPose planarTransform(const PlanarPose& from, const PlanarPose& to) {
  return compose(to, between(from, PlanarPose{}));
}

/// The motion of the later part after which `loop` has no residual.
PlanarPose partShift(const PlanarLink& loop, const std::vector<PlanarPose>& nodes,
                     bool visit_is_later) {
  if (visit_is_later) return planarTransform(nodes[loop.to], compose(nodes[loop.from], loop.pose));
  return planarTransform(nodes[loop.from],
                         compose(nodes[loop.to], between(loop.pose, PlanarPose{})));
}

}  // namespace

void ExperienceChain::startPart(const DeadReckoning& log) {
  Anchor& anchor = append(log);
  anchor.gap = true;
  anchor.way = {};
  begins_.push_back(static_cast<std::size_t>(current()));
}

std::size_t ExperienceChain::originOf(const Anchor& visit) const {
  return of_experience_[static_cast<std::size_t>(visit.experience)];
}

PathParts ExperienceChain::parts() const {
  PathParts parts(begins_);
  if (parts.count() == 1) return parts;
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    const Anchor& anchor = anchors_[i];
    const bool accepted = anchor.visit && anchor.offset_weight >= parameters_.min_loop_weight;
    if (accepted) parts.join(parts.of(i), parts.of(originOf(anchor)));
  }
  return parts;
}

/// If the visit is the first one between two parts (`before`: without it), moves the later part,
/// with all parts joined to it, so that the visit's loop has no residual.
void ExperienceChain::alignPart(const DeadReckoning& log, const PathParts& before,
                                std::size_t visit) {
  const std::size_t here = before.first(before.of(visit));
  const std::size_t there = before.first(before.of(originOf(anchors_[visit])));
  if (here == there) return;
  const auto poseAt = [&](std::size_t i) {
    return compose(anchors_[i].correction, toPlanar(log[anchors_[i].slot].T_start_camera));
  };
  std::vector<PlanarPose> nodes(anchors_.size());
  const PlanarLink loop = loopLink(log, visit);
  nodes[loop.from] = poseAt(loop.from);
  nodes[loop.to] = poseAt(loop.to);
  const PlanarPose shift = partShift(loop, nodes, here > there);
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    if (before.first(before.of(i)) != std::max(here, there)) continue;
    anchors_[i].correction = compose(shift, anchors_[i].correction);
  }
}

/// Tries the relative poses that rejected loops between parts propose; keeps the least energy.
void ExperienceChain::rearrange(const PathParts& parts, const PlanarGraph& start,
                                OptimiserOptions options, std::size_t attempts, PlanarGraph& best,
                                OptimiserOutcome& outcome) const {
  if (parts.count() == 1) return;
  const std::vector<PlanarLink> judged = best.links;
  for (std::size_t k = judged.size(); k-- > anchors_.size() - 1 && attempts > 0;) {
    const std::size_t from = parts.of(judged[k].from);
    const std::size_t to = parts.of(judged[k].to);
    if (from == to || judged[k].weight >= parameters_.min_loop_weight) continue;
    --attempts;
    PlanarGraph other = start;
    const PlanarPose shift = partShift(judged[k], other.nodes, to > from);
    for (std::size_t i = 0; i < other.nodes.size(); ++i) {
      if (parts.of(i) == std::max(from, to)) other.nodes[i] = compose(shift, other.nodes[i]);
    }
    for (PlanarLink& link : other.links) {
      if (link.robust) link.weight = isNear(link, other.nodes) ? 1 : kRejectedWeight;
    }
    const Result<OptimiserOutcome> found = optimise(options, other.nodes, other.links);
    if (!found.isOk() || found.value().energy >= outcome.energy) continue;
    outcome = found.value();
    best = std::move(other);
  }
}

void ExperienceChain::restore(const DeadReckoning& log, State state) {
  anchors_ = std::move(state.anchors);
  links_ = state.links;
  loops_ = state.loops;
  pending_ = state.pending;
  begins_ = {0};
  of_experience_.clear();
  last_visit_ = 0;
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    Anchor& anchor = anchors_[i];
    if (i > 0 && !anchor.gap) anchor.way = log.between(anchors_[i - 1].slot, anchor.slot);
    if (i > 0 && anchor.gap) begins_.push_back(i);
    if (anchor.visit) last_visit_ = i;
    if (!anchor.visit && anchor.experience >= 0) of_experience_.push_back(i);
  }
}

}  // namespace tolman::experience_map
