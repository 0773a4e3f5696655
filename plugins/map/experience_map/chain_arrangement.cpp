// SPDX-License-Identifier: BSD-3-Clause
#include "chain_arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "experience_chain.hpp"

namespace tolman::experience_map {

PathParts::PathParts(std::vector<std::size_t> begins)
    : begins_(std::move(begins)), first_(begins_.size()) {
  std::iota(first_.begin(), first_.end(), 0);
}

std::size_t PathParts::of(std::size_t anchor) const {
  const auto next = std::ranges::upper_bound(begins_, anchor);
  return static_cast<std::size_t>(next - begins_.begin()) - 1;
}

/// Linear in the number of parts, of which there are few.
void PathParts::join(std::size_t part, std::size_t other) {
  const auto [least, most] = std::minmax(first_[part], first_[other]);
  std::ranges::replace(first_, std::size_t{most}, std::size_t{least});
}

// Relative poses of the parts of a path with gaps. Least squares refines an arrangement of the
// parts, but needs a start near the minimum. Each loop between two parts determines one such start;
// the arrangement with the least energy is kept.

namespace {

/// A loop with a smaller residual after two parts were aligned starts with full weight: its
/// residual may come from drift within the parts, which is not yet corrected. Chosen, not tuned.
constexpr double kNearTranslation = 20;  // m
constexpr double kNearRotation = 0.5;    // rad

double metresOf(const Eigen::Vector3d& residual) { return residual.head<2>().norm(); }
double metresOf(const Vector6d& residual) { return residual.head<3>().norm(); }
double radiansOf(const Eigen::Vector3d& residual) { return std::abs(residual.z()); }
double radiansOf(const Vector6d& residual) { return residual.tail<3>().norm(); }

template <class G>
bool isNear(const PoseLink<G>& link, const std::vector<typename G::Pose>& nodes) {
  const StepOf<G> off = residualOf(link, nodes[link.from], nodes[link.to]);
  return metresOf(off) < kNearTranslation && radiansOf(off) < kNearRotation;
}

/// The motion in world coordinates that moves the pose `from` to the pose `to`.
template <class G>
typename G::Pose transform(const typename G::Pose& from, const typename G::Pose& to) {
  return compose(to, between(from, G::identity()));
}

/// The motion of the later part, in world coordinates, after which `loop` has no residual.
template <class G>
typename G::Pose partShift(const PoseLink<G>& loop, const typename G::Pose& from,
                           const typename G::Pose& to, bool visit_is_later) {
  if (visit_is_later) return transform<G>(to, compose(from, loop.pose));
  return transform<G>(from, compose(to, between(loop.pose, G::identity())));
}

}  // namespace

void ExperienceChain::startPart(const DeadReckoning& path) {
  Anchor& anchor = append(path);
  anchor.gap = true;
  anchor.odometry = {};
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

/// If the visit is the first one between two parts, moves the later part, with all parts joined to
/// it, so that the visit's loop has no residual. `before`: the parts without this visit.
void ExperienceChain::alignPart(const DeadReckoning& path, const PathParts& before,
                                std::size_t visit) {
  const std::size_t here = before.first(before.of(visit));
  const std::size_t there = before.first(before.of(originOf(anchors_[visit])));
  if (here == there) return;
  const bool is_later = here > there;
  const Eigen::Isometry3d shift = isSpatial(path) ? shiftOf<Space>(path, visit, is_later)
                                                  : shiftOf<Plane>(path, visit, is_later);
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    if (before.first(before.of(i)) != std::max(here, there)) continue;
    anchors_[i].correction = normalised(shift * anchors_[i].correction);
  }
}

template <class G>
Eigen::Isometry3d ExperienceChain::shiftOf(const DeadReckoning& path, std::size_t visit,
                                           bool visit_is_later) const {
  const PoseLink<G> loop = loopLink<G>(path, visit);
  const auto poseAt = [&](std::size_t i) {
    return compose(poseIn<G>(anchors_[i].correction),
                   poseIn<G>(path[anchors_[i].slot].T_start_camera));
  };
  return lifted(partShift(loop, poseAt(loop.from), poseAt(loop.to), visit_is_later));
}

/// Optimises once more for each rejected loop between two parts (at most `attempts`), starting with
/// the later part moved so that this loop has no residual. Keeps the arrangement of least energy.
template <class G>
void ExperienceChain::rearrange(const PathParts& parts, const std::vector<typename G::Pose>& start,
                                OptimiserOptions options, std::size_t attempts, PoseGraph<G>& best,
                                OptimiserOutcome& outcome, BorderedSystem<G>& system) const {
  if (parts.count() == 1) return;
  std::vector<PoseLink<G>>& links = best.links;
  const std::vector<double> weights = weightsOf(links);
  std::vector<double> kept = weights;
  std::vector<typename G::Pose> kept_nodes = best.nodes;
  const ErrorsOf<G> errors = best.errors.b;
  ErrorsOf<G> kept_errors = errors;
  for (std::size_t k = links.size(); k-- > anchors_.size() - 1 && attempts > 0;) {
    const std::size_t from = parts.of(links[k].from);
    const std::size_t to = parts.of(links[k].to);
    if (from == to || weights[k] >= parameters_.min_loop_weight) continue;
    --attempts;
    best.nodes = start;
    best.errors.b = errors;
    std::vector<typename G::Pose>& nodes = best.nodes;
    const typename G::Pose shift =
        partShift(links[k], nodes[links[k].from], nodes[links[k].to], to > from);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (parts.of(i) == std::max(from, to)) nodes[i] = compose(shift, nodes[i]);
    }
    for (PoseLink<G>& link : links) {
      if (link.robust) link.weight = isNear(link, nodes) ? 1 : kRejectedWeight;
    }
    const Result<OptimiserOutcome> found = optimise<G>(options, best, system);
    if (!found.isOk() || found.value().energy >= outcome.energy) continue;
    outcome = found.value();
    kept_nodes = best.nodes;
    kept_errors = best.errors.b;
    kept = weightsOf(links);
  }
  best.nodes = std::move(kept_nodes);
  best.errors.b = kept_errors;
  best.errors.correct(links);
  setWeights(links, kept);
}

template void ExperienceChain::rearrange<Plane>(const PathParts&, const std::vector<PlanarPose>&,
                                                OptimiserOptions, std::size_t, PoseGraph<Plane>&,
                                                OptimiserOutcome&, BorderedSystem<Plane>&) const;
template void ExperienceChain::rearrange<Space>(const PathParts&,
                                                const std::vector<Eigen::Isometry3d>&,
                                                OptimiserOptions, std::size_t, PoseGraph<Space>&,
                                                OptimiserOutcome&, BorderedSystem<Space>&) const;

void ExperienceChain::restore(const DeadReckoning& path, State state) {
  anchors_ = std::move(state.anchors);
  pending_ = state.pending;
  calibration_ = state.calibration;
  assumptions_ = state.assumptions;
  loops_when_estimated_ = state.loops_when_estimated;
  begins_ = {0};
  of_experience_.clear();
  last_visit_ = 0;
  measured_ = false;
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    Anchor& anchor = anchors_[i];
    if (i > 0 && !anchor.gap) anchor.odometry = path.between(anchors_[i - 1].slot, anchor.slot);
    if (i > 0 && anchor.gap) begins_.push_back(i);
    if (anchor.visit) last_visit_ = i;
    measured_ = measured_ || (anchor.visit && !anchor.assumed);
    if (!anchor.visit && anchor.experience >= 0) of_experience_.push_back(i);
  }
  countLinks();
}

// Loops that become known later: a visit is inserted into the chain at an earlier frame.

/// Updates all references to anchors after an anchor was inserted at index `i`.
void ExperienceChain::renumber(DeadReckoning& path, std::size_t i) {
  for (std::size_t& created : of_experience_) created += created >= i ? 1 : 0;
  for (std::size_t& begin : begins_) begin += begin >= i ? 1 : 0;
  last_visit_ = last_visit_ >= i ? last_visit_ + 1 : i;
  const auto before = static_cast<std::int64_t>(i) - 1;
  for (std::size_t slot = anchors_[i].slot; slot < path.size(); ++slot) {
    const std::int64_t anchor = path[slot].anchor;
    if (anchor >= before) path.moveTo(slot, anchor + 1);
  }
}

void ExperienceChain::insertVisit(DeadReckoning& path, std::size_t slot, std::int64_t experience,
                                  const UncertainPose& measured) {
  const auto i = static_cast<std::size_t>(path[slot].anchor) + 1;
  const Anchor before = anchors_[i - 1];
  if (before.slot == slot && before.visit) return;  // this frame has a loop already
  Anchor visit;
  visit.slot = slot;
  visit.experience = experience;
  visit.visit = true;
  visit.offset = withModel(measured);
  measured_ = true;
  visit.odometry = path.between(before.slot, slot);
  visit.correction = before.correction;
  anchors_.insert(anchors_.begin() + static_cast<std::ptrdiff_t>(i), visit);
  renumber(path, i);
  if (i + 1 < anchors_.size() && !anchors_[i + 1].gap) {
    anchors_[i + 1].odometry = path.between(slot, anchors_[i + 1].slot);
  }
  countLinks();
  pending_ = true;
  if (begins_.size() == 1) return;
  anchors_[i].offset_weight = 0;  // for the parts without this visit
  const PathParts without = parts();
  anchors_[i].offset_weight = 1;
  alignPart(path, without, i);
}

}  // namespace tolman::experience_map
