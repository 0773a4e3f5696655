// SPDX-License-Identifier: BSD-3-Clause
// What the detectors of wrong true poses share.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {

/// A stretch, from pair `first` to `last`, in which one of the two stands and the other moves.
struct Standing {
  std::size_t first = 0;
  std::size_t last = 0;
  double way = 0;   ///< of the one that moves, m
  double jump = 0;  ///< of the one that stands, after the stretch, m; 0 if it goes on without one
};

/// "the truth stands still from frame 3 to 9 while the estimate moves 12 m", and what to look for.
/// `is_truth`: whether it is the truth that stands. `still`: "still" or "almost still".
std::string standingText(const Standing& standing, const Matches& pairs, bool is_truth,
                         const char* still);

inline double distanceBetween(const Trajectory& path, std::size_t from, std::size_t to) {
  return (path[to].T_world_camera.translation() - path[from].T_world_camera.translation()).norm();
}

/// Median distance between consecutive poses that differ, m; 0 without any.
inline double usualStep(const Trajectory& path) {
  std::vector<double> steps = stepLengths(path);
  std::erase(steps, 0);
  return statistics(steps).median;
}

/// The shortest way that truth and estimate must differ by, m.
inline double leastWay(const Trajectory& truth) {
  constexpr double kMoved = 0.5;        // m; chosen, not tuned
  constexpr double kShareMoved = 0.01;  // of the true path, for small rooms; chosen, not tuned
  return std::min(kMoved, kShareMoved * pathLength(truth));
}

}  // namespace tolman::evaluation
