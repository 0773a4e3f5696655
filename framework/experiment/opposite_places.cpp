// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/opposite_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "evaluation/loop_truth.hpp"

namespace tolman::bench {
namespace {

OppositePlaces::Claim judged(const evaluation::Trajectory& truth, const TurnedAnswer& answer,
                             const dataset::RevisitRule& rule) {
  const auto pose = [&](std::int64_t image) -> const Eigen::Isometry3d& {
    return truth[static_cast<std::size_t>(image)].T_world_camera;
  };
  const Eigen::Isometry3d claimed = pose(answer.place) * answer.T_place_query;
  const double error = (claimed.translation() - pose(answer.query).translation()).norm();
  const bool is_opposite = dataset::headingBetween(pose(answer.place), pose(answer.query), rule) ==
                           dataset::Heading::Opposite;
  const bool is_there = dataset::isSamePlace(claimed, pose(answer.query), rule);
  return {answer.query, answer.place, answer.score, error, is_opposite && is_there};
}

/// The images that return to a place in the opposite direction, but not in the same direction.
std::set<std::int64_t> findableOf(const evaluation::Trajectory& truth,
                                  const dataset::RevisitRule& rule) {
  std::set<std::int64_t> same;
  std::set<std::int64_t> opposite;
  for (const dataset::Revisit& revisit : dataset::findRevisits(truth, rule)) {
    (revisit.heading == dataset::Heading::Same ? same : opposite).insert(revisit.frame);
  }
  for (const std::int64_t image : same) opposite.erase(image);
  return opposite;
}

}  // namespace

bool isTurned(const PlaceObservation& seen) {
  return std::abs(wrapAngle(seen.relative_yaw)) > std::numbers::pi / 2;
}

Eigen::Isometry3d claimedPose(const PlaceObservation& seen) {
  return seen.has_relative_pose ? seen.T_template_current : fromPlanar({0, 0, seen.relative_yaw});
}

std::int64_t OppositePlaces::right() const { return std::ranges::count_if(claims, &Claim::right); }

double OppositePlaces::medianError() const {
  std::vector<double> errors;
  for (const Claim& claim : claims) {
    if (claim.right) errors.push_back(claim.error_m);
  }
  if (errors.empty()) return 0;
  std::ranges::sort(errors);
  return errors[errors.size() / 2];
}

OppositePlaces judgeOpposite(const evaluation::Trajectory& truth,
                             const std::vector<TurnedAnswer>& answers, double height_m) {
  dataset::RevisitRule rule;
  rule.height_m = height_m;
  OppositePlaces places;
  for (const TurnedAnswer& answer : answers) places.claims.push_back(judged(truth, answer, rule));
  const std::vector<double> path = evaluation::distances(truth);
  const auto pathOf = [&](std::int64_t image) { return path[static_cast<std::size_t>(image)]; };
  for (const std::int64_t image : findableOf(truth, rule)) {
    ++places.findable;
    places.found += std::ranges::any_of(places.claims, [&](const OppositePlaces::Claim& claim) {
      const double since = pathOf(image) - pathOf(claim.query);
      return claim.right && claim.query <= image && since <= rule.distance_m;
    });
  }
  return places;
}

}  // namespace tolman::bench
