// SPDX-License-Identifier: BSD-3-Clause
// Which pose of an estimate belongs to which pose of the truth.
#pragma once

#include <algorithm>
#include <cstdint>

#include "evaluation/trajectory.hpp"
#include "tolman/status.hpp"

namespace tolman::evaluation {

/// Pairs of poses: truth[i] and estimate[i] are of one moment. Never empty.
struct Matches {
  Trajectory truth;
  Trajectory estimate;
  std::size_t truth_total = 0;  ///< poses of the truth, matched or not

  std::size_t size() const { return truth.size(); }
  /// The share of the truth that has a tracked pose.
  double coverage() const {
    const auto tracked = std::ranges::count(estimate, true, &TrajectoryPose::tracked);
    return static_cast<double>(tracked) / static_cast<double>(truth_total);
  }
};

/// Matches equal frame indices. InvalidInput when nothing matches.
Result<Matches> associateByFrame(const Trajectory& truth, const Trajectory& estimate);

/// Matches each estimate with the nearest truth in time, at most `max_difference_ns` away; of
/// several estimates of one truth the nearest wins. InvalidInput when nothing matches.
Result<Matches> associateByStamp(const Trajectory& truth, const Trajectory& estimate,
                                 std::int64_t max_difference_ns);

}  // namespace tolman::evaluation
