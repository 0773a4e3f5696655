// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/association.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace tolman::evaluation {
namespace {

Result<Matches> checked(Matches matches, const Trajectory& estimate, const std::string& rule) {
  if (matches.size() > 0) return matches;
  return Status::invalidInput("no pose of the estimate (" + std::to_string(estimate.size()) +
                              ") matches one of the truth (" + std::to_string(matches.truth_total) +
                              ") by " + rule + "; check that both are of the same run");
}

std::int64_t difference(const TrajectoryPose& a, const TrajectoryPose& b) {
  return std::abs(a.stamp_ns - b.stamp_ns);
}

/// The pose of the non-empty `truth` that is nearest in time.
const TrajectoryPose& nearest(const Trajectory& truth, const TrajectoryPose& pose) {
  const auto after = std::lower_bound(
      truth.begin(), truth.end(), pose.stamp_ns,
      [](const TrajectoryPose& candidate, std::int64_t ns) { return candidate.stamp_ns < ns; });
  if (after == truth.begin()) return *after;
  const auto before = std::prev(after);
  if (after == truth.end()) return *before;
  return difference(*after, pose) < difference(*before, pose) ? *after : *before;
}

}  // namespace

Result<Matches> associateByFrame(const Trajectory& truth, const Trajectory& estimate) {
  Matches matches;
  matches.truth_total = truth.size();
  auto candidate = truth.begin();
  for (const TrajectoryPose& pose : estimate) {
    while (candidate != truth.end() && candidate->frame < pose.frame) ++candidate;
    if (candidate == truth.end()) break;
    if (candidate->frame != pose.frame) continue;
    matches.truth.push_back(*candidate);
    matches.estimate.push_back(pose);
  }
  return checked(std::move(matches), estimate, "frame index");
}

Result<Matches> associateByStamp(const Trajectory& truth, const Trajectory& estimate,
                                 std::int64_t max_difference_ns) {
  Matches matches;
  matches.truth_total = truth.size();
  for (const TrajectoryPose& pose : estimate) {
    if (truth.empty()) break;
    const TrajectoryPose& candidate = nearest(truth, pose);
    if (difference(candidate, pose) > max_difference_ns) continue;
    if (matches.size() > 0 && matches.truth.back().frame == candidate.frame) {
      if (difference(candidate, pose) < difference(candidate, matches.estimate.back())) {
        matches.estimate.back() = pose;
      }
      continue;
    }
    matches.truth.push_back(candidate);
    matches.estimate.push_back(pose);
  }
  return checked(std::move(matches), estimate,
                 "stamp within " + std::to_string(max_difference_ns) + " ns");
}

}  // namespace tolman::evaluation
