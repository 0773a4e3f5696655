// SPDX-License-Identifier: BSD-3-Clause
// Growth, revision and correction of the chain.
#include "experience_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tolman::experience_map {
namespace {

/// Nothing is known of the motion over a gap: beside loops it must weigh nothing. Where there are
/// none it holds the part in place, or the system would be singular.
Eigen::Matrix3d gapCovariance(bool holds) {
  constexpr double kLooseVariance = 1e6;      // m^2
  constexpr double kLooseVarianceTurn = 1e4;  // rad^2
  if (holds) return Eigen::Matrix3d::Identity();
  return Eigen::Vector3d(kLooseVariance, kLooseVariance, kLooseVarianceTurn).asDiagonal();
}

}  // namespace

Anchor& ExperienceChain::append(const MotionLog& log) {
  const Anchor& before = anchors_.back();
  Anchor anchor;
  anchor.slot = log.last();
  anchor.way = log.between(before.slot, anchor.slot);
  anchor.correction = before.correction;  // no jump: the robot stays where it believes to be
  anchors_.push_back(anchor);
  return anchors_.back();
}

void ExperienceChain::addExperience(const MotionLog& log, std::int64_t template_id) {
  const Anchor& last = anchors_.back();
  const bool begins_part = last.slot == log.last() && (last.gap || current() == 0);
  const bool linked = !begins_part && last.experience >= 0;
  Anchor& anchor = begins_part ? anchors_.back() : append(log);
  anchor.experience = experiences();
  anchor.template_id = template_id;
  if (linked) ++links_;
  of_experience_.push_back(static_cast<std::size_t>(current()));
}

void ExperienceChain::addVisit(const MotionLog& log, std::int64_t experience,
                               const UncertainPose& measured) {
  const Matrix6d model =
      isotropic(parameters_.measured_sigma_translation, parameters_.measured_sigma_rotation);
  addVisit(log, experience, {measured.T, measured.covariance + model}, false);
}

void ExperienceChain::addVisit(const MotionLog& log, std::int64_t experience, double relative_yaw) {
  // The unknown offset is alike for all visits of one traversal (a match always comes 2 m early,
  // say). Were they independent, many of them would outvote good odometry: hence the factor.
  int run = 1;
  for (std::size_t i = anchors_.size(); i-- > 0 && anchors_[i].assumed; ++run) {
    if (run == parameters_.assumed_run) break;
  }
  const Matrix6d covariance =
      run * isotropic(parameters_.assumed_sigma_translation, parameters_.assumed_sigma_rotation);
  addVisit(log, experience, {fromPlanar({0, 0, relative_yaw}), covariance}, true);
}

void ExperienceChain::addVisit(const MotionLog& log, std::int64_t experience,
                               const UncertainPose& offset, bool assumed) {
  const PathParts before = parts();
  const std::int64_t last = anchors_.back().experience;
  const bool folded = last >= 0 && last != experience;  // no link from a node to itself
  Anchor& anchor = append(log);
  anchor.experience = experience;
  anchor.visit = true;
  anchor.assumed = assumed;
  anchor.offset = offset;
  if (folded) ++links_, ++loops_;
  last_visit_ = static_cast<std::size_t>(current());
  pending_ = true;
  if (before.count() > 1) layOver(log, before);
}

void ExperienceChain::refresh(const MotionLog& log, std::size_t first) {
  for (std::size_t i = anchors_.size(); i-- > 1 && anchors_[i].slot >= first;) {
    if (!anchors_[i].gap) anchors_[i].way = log.between(anchors_[i - 1].slot, anchors_[i].slot);
  }
  // Behind the last visit the chain is free: no loop strains it, whatever its motions are.
  if (last_visit_ > 0 && first <= anchors_[last_visit_].slot) pending_ = true;
}

Status ExperienceChain::correct(const MotionLog& log, int iterations, double tolerance) {
  pending_ = false;
  if (last_visit_ == 0) return Status::ok();
  return optimiseAll(log, {.iterations = iterations, .tolerance = tolerance}, Care::Brief);
}

Status ExperienceChain::judge(const MotionLog& log, int iterations, double tolerance) {
  pending_ = false;
  if (last_visit_ == 0) return Status::ok();
  Status status =
      optimiseAll(log, {.iterations = iterations, .tolerance = tolerance}, Care::Thorough);
  for (Anchor& anchor : anchors_) {
    anchor.taken_back = anchor.visit && anchor.offset_weight < parameters_.disbelief;
  }
  return status;
}

ExperienceChain::Sketch ExperienceChain::sketch(const MotionLog& log) const {
  Sketch sketch;
  for (const Anchor& anchor : anchors_) {
    sketch.reckoned.push_back(toPlanar(log[anchor.slot].T_start_camera));
    sketch.nodes.push_back(compose(anchor.correction, sketch.reckoned.back()));
  }
  const PathParts joined = parts();
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    sketch.links.push_back(wayLink(log, i, joined));
  }
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    if (anchors_[i].visit) sketch.links.push_back(loopLink(log, i));
  }
  return sketch;
}

Status ExperienceChain::optimiseAll(const MotionLog& log, OptimiserOptions options, Care care) {
  constexpr std::size_t kThoroughAttempts = 10;
  options.solver = parameters_.solver;
  options.loss = parameters_.loss;
  options.delta =
      options.loss == Loss::Huber ? parameters_.huber_delta : parameters_.geman_mcclure_scale;
  const Sketch start = sketch(log);
  Sketch found = start;
  const Result<Outcome> outcome =
      care == Care::Brief
          ? optimise(options, found.nodes, found.links)
          : experience_map::judge(options, found.reckoned, found.nodes, found.links);
  if (!outcome.isOk()) return outcome.status();
  Outcome best = outcome.value();
  rearrange(parts(), start, options, care == Care::Brief ? 1 : kThoroughAttempts, found, best);
  pending_ = !best.converged;
  apply(found);
  return Status::ok();
}

void ExperienceChain::apply(const Sketch& sketch) {
  std::size_t loop = anchors_.size() - 1;  // loops come after all ways
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    Anchor& anchor = anchors_[i];
    anchor.correction = compose(sketch.nodes[i], tolman::between(sketch.reckoned[i], PlanarPose{}));
    anchor.way_weight = sketch.links[i - 1].weight;
    if (anchor.visit) anchor.offset_weight = sketch.links[loop++].weight;
  }
}

PlanarLink ExperienceChain::wayLink(const MotionLog& log, std::size_t i,
                                    const PathParts& parts) const {
  // Seen in the plane of the world, not of the leaning camera: dead reckoning then has no residual.
  const PlanarPose from = toPlanar(log[anchors_[i - 1].slot].T_start_camera);
  const Eigen::Isometry3d& T_start_to = log[anchors_[i].slot].T_start_camera;
  const Eigen::Matrix3d covariance =
      anchors_[i].gap
          ? gapCovariance(parts.first(parts.of(i)) == parts.of(i))
          : planarCovariance(anchors_[i].way.covariance, T_start_to.linear(), from.theta);
  return {.from = i - 1,
          .to = i,
          .pose = tolman::between(from, toPlanar(T_start_to)),
          .covariance = covariance,
          .robust = parameters_.huber_odometry && parameters_.loss == Loss::Huber,
          .weight = anchors_[i].way_weight};
}

PlanarLink ExperienceChain::loopLink(const MotionLog& log, std::size_t i) const {
  const Anchor& visit = anchors_[i];
  const Eigen::Isometry3d& T_start_home = log[home(visit.experience).slot].T_start_camera;
  const Eigen::Isometry3d T_start_visit = T_start_home * visit.offset.T;
  const PlanarPose from = toPlanar(T_start_home);
  return {
      .from = of_experience_[static_cast<std::size_t>(visit.experience)],
      .to = i,
      .pose = tolman::between(from, toPlanar(T_start_visit)),
      .covariance = planarCovariance(visit.offset.covariance, T_start_visit.linear(), from.theta),
      .weight = visit.offset_weight};
}

const Anchor& ExperienceChain::home(std::int64_t experience) const {
  return anchors_[of_experience_[static_cast<std::size_t>(experience)]];
}

Eigen::Isometry3d ExperienceChain::T_world_camera(const MotionLog& log, std::size_t slot) const {
  return fromPlanar((*this)[log[slot].anchor].correction) * log[slot].T_start_camera;
}

Eigen::Isometry3d ExperienceChain::T_world_experience(const MotionLog& log,
                                                      std::int64_t experience) const {
  const Anchor& anchor = home(experience);
  return fromPlanar(anchor.correction) * log[anchor.slot].T_start_camera;
}

Place ExperienceChain::place(const MotionLog& log, std::size_t slot) const {
  auto i = static_cast<std::size_t>(log[slot].anchor);
  while (i > 0 && anchors_[i].visit && anchors_[i].offset_weight < parameters_.disbelief) --i;
  const Anchor& anchor = anchors_[i];
  if (anchor.experience < 0) return {-1, T_world_camera(log, slot)};
  // As the map sees it now, not as the loop says: a false loop then does no harm here.
  const Eigen::Isometry3d T_experience_camera =
      T_world_experience(log, anchor.experience).inverse() * T_world_camera(log, slot);
  return {anchor.experience, T_experience_camera};
}

Link ExperienceChain::foldedLink(const MotionLog& log, std::size_t before, std::size_t i) const {
  constexpr double kLeastWeight = 1e-6;
  const Anchor& from = anchors_[before];
  const Anchor& to = anchors_[i];
  UncertainPose pose;
  if (from.visit) {  // where the visit really was, as far as is known now
    pose.T = T_world_experience(log, from.experience).inverse() * T_world_camera(log, from.slot);
    pose.covariance = from.offset.covariance / std::max(from.offset_weight, kLeastWeight);
  }
  pose = compose(pose, before + 1 == i ? to.way : log.between(from.slot, to.slot));
  if (to.visit) pose = compose(pose, inverse(to.offset));
  Link link;
  link.from = from.experience;
  link.to = to.experience;
  link.kind = to.visit ? LinkKind::Loop : LinkKind::Odometry;
  link.frame = log[to.slot].frame;
  link.T_from_to = pose.T;
  link.covariance = 0.5 * (pose.covariance + pose.covariance.transpose());
  link.duration = to.visit ? 0 : log.seconds(from.slot, to.slot);
  link.weight = to.visit ? to.offset_weight : to.way_weight;
  return link;
}

void ExperienceChain::graph(const MotionLog& log, MapGraph& graph) const {
  graph.experiences.clear();
  graph.links.clear();
  for (const std::size_t i : of_experience_) {
    const Anchor& anchor = anchors_[i];
    graph.experiences.push_back({anchor.experience, log[anchor.slot].frame, anchor.template_id,
                                 T_world_experience(log, anchor.experience)});
  }
  std::size_t before = 0;
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    if (!counts(anchors_[i])) continue;
    const std::size_t previous = std::exchange(before, i);
    const std::int64_t from = anchors_[previous].experience;
    if (from < 0 || from == anchors_[i].experience || anchors_[i].gap) continue;
    Link link = foldedLink(log, previous, i);
    link.id = static_cast<std::int64_t>(graph.links.size());
    graph.links.push_back(link);
  }
}

}  // namespace tolman::experience_map
