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

/// Whether the stamps of poses that are matched by frame index agree.
enum class StampAgreement : std::uint8_t {
  Agrees,      ///< at most half a frame period apart; or there are no stamps
  OtherClock,  ///< the difference is constant, and the two periods of time do not overlap
  Contradicts,
};
struct StampComparison {
  StampAgreement agreement = StampAgreement::Agrees;
  std::int64_t apart_ns = 0;   ///< the largest difference of two matched poses
  std::int64_t period_ns = 0;  ///< median step of the truth; 0 without stamps
};
StampComparison compareStamps(const Trajectory& truth, const Trajectory& estimate);

}  // namespace tolman::evaluation
