// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/association.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace tolman::evaluation {
namespace {

/// Whether poses `from` and `to` of the estimate have others between them that show a longer way
/// than the straight line. The noise of a robot that stands is none.
bool isBent(const Trajectory& estimate, std::size_t from, std::size_t to) {
  constexpr double kLonger = 0.1;  // of the straight line
  constexpr double kNoise = 0.25;  // m
  if (to <= from + 1) return false;
  const auto position = [&](std::size_t i) -> Eigen::Vector3d {
    return estimate[i].T_world_camera.translation();
  };
  double length = 0;
  for (std::size_t i = from; i < to; ++i) length += (position(i + 1) - position(i)).norm();
  const double straight = (position(to) - position(from)).norm();
  return length - straight > std::max(kLonger * straight, kNoise);
}

/// `which`: of each matched pose in the whole estimate.
std::vector<std::size_t> piecesOf(const Matches& matches, const Trajectory& estimate,
                                  const std::vector<std::size_t>& which) {
  std::vector<std::size_t> pieces(matches.size(), 0);
  for (std::size_t i = 1; i < matches.size(); ++i) {
    const bool carried = matches.truth[i].session != matches.truth[i - 1].session;
    pieces[i] = pieces[i - 1] + (carried || isBent(estimate, which[i - 1], which[i]) ? 1 : 0);
  }
  return pieces;
}

Result<Matches> checked(Matches matches, const Trajectory& truth, const Trajectory& estimate,
                        const std::vector<std::size_t>& which, const std::string& rule) {
  matches.piece = piecesOf(matches, estimate, which);
  const std::vector<double> driven = distances(truth);
  for (const std::size_t i : matches.index) matches.driven.push_back(driven[i]);
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

std::int64_t medianStep(const Trajectory& trajectory) {
  if (trajectory.size() < 2) return 0;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    steps.push_back(trajectory[i].stamp_ns - trajectory[i - 1].stamp_ns);
  }
  const auto median = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), median, steps.end());
  return *median;
}

}  // namespace

Result<Matches> associateByFrame(const Trajectory& truth, const Trajectory& estimate) {
  Matches matches;
  matches.truth_total = truth.size();
  std::vector<std::size_t> which;
  auto candidate = truth.begin();
  for (const TrajectoryPose& pose : estimate) {
    while (candidate != truth.end() && candidate->frame < pose.frame) ++candidate;
    if (candidate == truth.end()) break;
    if (candidate->frame != pose.frame) continue;
    matches.truth.push_back(*candidate);
    matches.estimate.push_back(pose);
    matches.index.push_back(static_cast<std::size_t>(candidate - truth.begin()));
    which.push_back(static_cast<std::size_t>(&pose - estimate.data()));
  }
  return checked(std::move(matches), truth, estimate, which, "frame index");
}

Result<Matches> associateByStamp(const Trajectory& truth, const Trajectory& estimate,
                                 std::int64_t max_difference_ns) {
  Matches matches;
  matches.truth_total = truth.size();
  std::vector<std::size_t> which;
  for (const TrajectoryPose& pose : estimate) {
    if (truth.empty()) break;
    const TrajectoryPose& candidate = nearest(truth, pose);
    if (difference(candidate, pose) > max_difference_ns) continue;
    if (matches.size() > 0 && matches.truth.back().frame == candidate.frame) {
      if (difference(candidate, pose) < difference(candidate, matches.estimate.back())) {
        matches.estimate.back() = pose;
        which.back() = static_cast<std::size_t>(&pose - estimate.data());
      }
      continue;
    }
    matches.truth.push_back(candidate);
    matches.estimate.push_back(pose);
    matches.index.push_back(static_cast<std::size_t>(&candidate - truth.data()));
    which.push_back(static_cast<std::size_t>(&pose - estimate.data()));
  }
  return checked(std::move(matches), truth, estimate, which,
                 "stamp within " + std::to_string(max_difference_ns) + " ns");
}

Result<Matches> associate(const Trajectory& truth, const Trajectory& estimate,
                          std::int64_t max_difference_ns) {
  if (truth.empty()) return Status::invalidInput("there is no ground truth");
  if (estimate.empty()) return Status::invalidInput("there is no estimate");
  return max_difference_ns < 0 ? associateByFrame(truth, estimate)
                               : associateByStamp(truth, estimate, max_difference_ns);
}

std::int64_t usualDifference(const Trajectory& truth, const Trajectory& estimate) {
  constexpr std::int64_t kLeast = 20'000'000;  // ns
  if (!hasStamps(truth) || !hasStamps(estimate)) return -1;
  const bool overlap = truth.front().stamp_ns <= estimate.back().stamp_ns &&
                       estimate.front().stamp_ns <= truth.back().stamp_ns;
  return overlap ? std::max(kLeast, std::min(medianStep(truth), medianStep(estimate)) / 2) : -1;
}

}  // namespace tolman::evaluation
