// SPDX-License-Identifier: BSD-3-Clause
#include "experience_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tolman::experience_map {

Anchor& ExperienceChain::append(const DeadReckoning& path) {
  const Anchor& before = anchors_.back();
  Anchor anchor;
  anchor.slot = path.last();
  anchor.odometry = path.between(before.slot, anchor.slot);
  anchor.correction = before.correction;  // so that the pose estimate does not jump
  anchors_.push_back(anchor);
  return anchors_.back();
}

void ExperienceChain::addExperience(const DeadReckoning& path, std::int64_t template_id) {
  const Anchor& last = anchors_.back();
  const bool begins_part = last.slot == path.last() && (last.gap || current() == 0);
  Anchor& anchor = begins_part ? anchors_.back() : append(path);
  anchor.experience = experiences();
  anchor.template_id = template_id;
  countLastLink();
  of_experience_.push_back(static_cast<std::size_t>(current()));
}

/// Adds the parameters' variances: the covariances of place recognition tend to be too small.
UncertainPose ExperienceChain::withModel(const UncertainPose& measured) const {
  return {measured.T, measured.covariance + isotropic(parameters_.measured_sigma_translation,
                                                      parameters_.measured_sigma_rotation)};
}

void ExperienceChain::addVisit(const DeadReckoning& path, std::int64_t experience,
                               const UncertainPose& measured) {
  addVisit(path, experience, withModel(measured), false);
}

void ExperienceChain::addVisit(const DeadReckoning& path, std::int64_t experience,
                               double relative_yaw) {
  // The unknown offsets of successive visits are correlated: for example, each match may come 2 m
  // early. The variance grows with the number of successive visits, so that cells that close a loop
  // at every frame do not outweigh good odometry. No cells of this repository do so: with them
  // limits of 1 to 9 give the same results on all available drives.
  constexpr int kLongestRun = 3;
  int run = 1;
  for (std::size_t i = anchors_.size(); i-- > 0 && anchors_[i].assumed; ++run) {
    if (run == kLongestRun) break;
  }
  const Matrix6d covariance =
      run * isotropic(parameters_.assumed_sigma_translation, parameters_.assumed_sigma_rotation);
  addVisit(path, experience, {fromPlanar({0, 0, relative_yaw}), covariance}, true);
}

void ExperienceChain::addVisit(const DeadReckoning& path, std::int64_t experience,
                               const UncertainPose& offset, bool assumed) {
  const PathParts before = parts();
  Anchor& anchor = append(path);
  anchor.experience = experience;
  anchor.visit = true;
  anchor.assumed = assumed;
  measured_ = measured_ || !assumed;
  anchor.offset = offset;
  last_visit_ = static_cast<std::size_t>(current());
  countLastLink();
  pending_ = true;
  if (before.count() > 1) alignPart(path, before, last_visit_);
}

void ExperienceChain::refresh(const DeadReckoning& path, std::size_t first) {
  for (std::size_t i = anchors_.size(); i-- > 1 && anchors_[i].slot >= first;) {
    if (!anchors_[i].gap)
      anchors_[i].odometry = path.between(anchors_[i - 1].slot, anchors_[i].slot);
  }
  // Motions after the last visit are in no cycle of the graph: there is nothing to optimise.
  if (last_visit_ > 0 && first <= anchors_[last_visit_].slot) pending_ = true;
}

const Anchor& ExperienceChain::origin(std::int64_t experience) const {
  return anchors_[of_experience_[static_cast<std::size_t>(experience)]];
}

Eigen::Isometry3d ExperienceChain::T_world_camera(const DeadReckoning& path,
                                                  std::size_t slot) const {
  return (*this)[path[slot].anchor].correction * path[slot].T_start_camera;
}

Eigen::Isometry3d ExperienceChain::T_world_experience(const DeadReckoning& path,
                                                      std::int64_t experience) const {
  const Anchor& anchor = origin(experience);
  return anchor.correction * path[anchor.slot].T_start_camera;
}

ExperiencePose ExperienceChain::experiencePose(const DeadReckoning& path, std::size_t slot) const {
  auto i = static_cast<std::size_t>(path[slot].anchor);
  while (i > 0 && anchors_[i].visit && anchors_[i].offset_weight < parameters_.min_loop_weight) --i;
  const Anchor& anchor = anchors_[i];
  if (anchor.experience < 0) return {-1, T_world_camera(path, slot)};
  // From the optimised poses, not from the offset of the visit, which may be false.
  const Eigen::Isometry3d T_experience_camera =
      T_world_experience(path, anchor.experience).inverse() * T_world_camera(path, slot);
  return {anchor.experience, T_experience_camera};
}

bool ExperienceChain::isLinked(std::size_t previous, std::size_t i) const {
  const std::int64_t from = anchors_[previous].experience;
  return from >= 0 && from != anchors_[i].experience && !anchors_[i].gap;
}

void ExperienceChain::countLastLink() {
  const std::size_t last = anchors_.size() - 1;
  if (last == 0) return;
  std::size_t previous = last - 1;
  while (anchors_[previous].rejected) --previous;  // ends at the first anchor, which is not a visit
  if (!isLinked(previous, last)) return;
  ++links_;
  if (anchors_[last].visit) ++loops_;
}

void ExperienceChain::countLinks() {
  links_ = loops_ = 0;
  std::size_t before = 0;
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    const std::size_t previous = anchors_[i].rejected ? before : std::exchange(before, i);
    if (!isLinked(previous, i)) continue;
    ++links_;
    if (anchors_[i].visit) ++loops_;
  }
}

std::size_t ExperienceChain::slotOfPassing(const DeadReckoning& path, std::size_t i) const {
  const Anchor& anchor = anchors_[i];
  std::size_t nearest = anchor.slot;
  if (!anchor.visit) return nearest;
  // All in the coordinates of dead reckoning, as the anchor's correction has it.
  const Eigen::Vector3d experience =
      anchor.correction.inverse() * T_world_experience(path, anchor.experience).translation();
  const auto distance = [&](std::size_t slot) {
    return (path[slot].T_start_camera.translation() - experience).squaredNorm();
  };
  while (nearest > 0 && !path[nearest].gap && distance(nearest - 1) < distance(nearest)) --nearest;
  if (nearest < anchor.slot) return nearest;
  while (nearest < path.last() && !path[nearest + 1].gap &&
         distance(nearest + 1) < distance(nearest))
    ++nearest;
  return nearest;
}

double ExperienceChain::seconds(const DeadReckoning& path, std::size_t before,
                                std::size_t i) const {
  return std::abs(path.seconds(slotOfPassing(path, before), anchors_[i].slot));
}

Link ExperienceChain::mergedLink(const DeadReckoning& path, std::size_t before,
                                 std::size_t i) const {
  constexpr double kMinWeight = 1e-6;  // keeps the division finite
  const Anchor& from = anchors_[before];
  const Anchor& to = anchors_[i];
  UncertainPose pose;
  if (from.visit) {  // the optimised pose of the visit
    pose.T = T_world_experience(path, from.experience).inverse() * T_world_camera(path, from.slot);
    pose.covariance = from.offset.covariance / std::max(from.offset_weight, kMinWeight);
  }
  pose = compose(pose, before + 1 == i ? to.odometry : path.between(from.slot, to.slot));
  if (to.visit) pose = compose(pose, inverse(to.offset));
  Link link;
  link.from = from.experience;
  link.to = to.experience;
  link.kind = to.visit ? LinkKind::Loop : LinkKind::Odometry;
  link.frame = path[to.slot].frame;
  link.T_from_to = pose.T;
  link.covariance = 0.5 * (pose.covariance + pose.covariance.transpose());
  link.duration = to.visit ? 0 : seconds(path, before, i);
  link.weight = to.visit ? to.offset_weight : to.odometry_weight;
  return link;
}

void ExperienceChain::graph(const DeadReckoning& path, MapGraph& graph) const {
  graph.experiences.clear();
  graph.links.clear();
  graph.rejected.clear();
  graph.residuals.clear();
  graph.experiences.reserve(of_experience_.size());
  graph.links.reserve(static_cast<std::size_t>(links_));  // growing would take twice the memory
  for (const std::size_t i : of_experience_) {
    const Anchor& anchor = anchors_[i];
    graph.experiences.push_back({anchor.experience, path[anchor.slot].frame, anchor.template_id,
                                 T_world_experience(path, anchor.experience)});
  }
  std::size_t before = 0;
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    const std::size_t previous = anchors_[i].rejected ? before : std::exchange(before, i);
    if (!isLinked(previous, i)) continue;
    Link link = mergedLink(path, previous, i);
    link.id = static_cast<std::int64_t>(graph.links.size());
    const bool loop = link.kind == LinkKind::Loop;
    if (anchors_[i].rejected || (loop && link.weight < parameters_.min_loop_weight)) {
      graph.rejected.push_back(link.id);
    }
    graph.links.push_back(link);
    if (!residuals_.empty()) graph.residuals.push_back(loop ? anchors_[i].residual : -1);
  }
}

}  // namespace tolman::experience_map
