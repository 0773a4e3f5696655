// SPDX-License-Identifier: BSD-3-Clause
// Matches the poses of an estimate with the poses of the truth.
#pragma once

#include <algorithm>
#include <cstdint>

#include "evaluation/trajectory.hpp"
#include "tolman/status.hpp"

namespace tolman::evaluation {

/// Pairs of poses: truth[i] and estimate[i] belong to the same time. Never empty.
struct Matches {
  Trajectory truth;
  Trajectory estimate;
  std::vector<std::size_t> index;  ///< of truth[i] in the whole truth; ascending
  std::vector<double> driven;      ///< m: length of the whole true path up to truth[i]
  /// Number of the piece of the path that pair i belongs to. How far the robot drove from one piece
  /// to the next is not known: they are of different sessions, or the truth has a gap in which the
  /// estimate is over a tenth longer than the straight line.
  std::vector<std::size_t> piece;
  std::size_t truth_total = 0;  ///< poses of the truth, matched or not

  std::size_t size() const { return truth.size(); }
  bool inOnePiece(std::size_t from, std::size_t to) const { return piece[from] == piece[to]; }
  /// The share of the truth that has a tracked pose.
  double coverage() const {
    const auto tracked = std::ranges::count(estimate, true, &TrajectoryPose::tracked);
    return static_cast<double>(tracked) / static_cast<double>(truth_total);
  }
};

/// Matches equal frame indices. InvalidInput when nothing matches.
Result<Matches> associateByFrame(const Trajectory& truth, const Trajectory& estimate);

/// Matches each estimate with the nearest truth in time, at most `max_difference_ns` away. If
/// several estimates have the same truth, the nearest is kept. InvalidInput when nothing matches.
Result<Matches> associateByStamp(const Trajectory& truth, const Trajectory& estimate,
                                 std::int64_t max_difference_ns);

/// By stamp; by frame index where `max_difference_ns` < 0. InvalidInput says which is empty.
Result<Matches> associate(const Trajectory& truth, const Trajectory& estimate,
                          std::int64_t max_difference_ns);

/// How far apart in time poses may be that belong together, unless the user states it: half of the
/// shorter usual step of the two, and at least 20 ms. -1, by frame index, if one of them has no
/// stamps, or if their clocks have no moment in common.
std::int64_t usualDifference(const Trajectory& truth, const Trajectory& estimate);

}  // namespace tolman::evaluation
