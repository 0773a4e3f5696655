// SPDX-License-Identifier: BSD-3-Clause
// What the detectors of wrong true poses share.
#pragma once

#include <algorithm>
#include <vector>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {

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
