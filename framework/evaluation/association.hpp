// SPDX-License-Identifier: BSD-3-Clause
// Matches the poses of an estimate with the poses of the truth.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "evaluation/trajectory.hpp"
#include "tolman/status.hpp"

namespace tolman::evaluation {

/// Pairs of poses: truth[i] and estimate[i] belong to the same time. Never empty.
struct Matches {
  Trajectory truth;
  Trajectory estimate;
  std::vector<std::size_t> index;  ///< of truth[i], or the true pose before it, in the whole truth
  std::vector<double> driven;      ///< m: length of the whole true path up to truth[i]
  /// Number of the piece of the path that pair i belongs to. How far the robot drove from one piece
  /// to the next is not known: they are of different sessions, or the truth has a gap in which the
  /// estimate is over a tenth longer than the straight line.
  std::vector<std::size_t> piece;
  /// Poses that an estimate without gaps would have: by frame all of the truth; by stamp as many
  /// as fit into the time of the truth at the usual rate of the matches.
  std::size_t truth_total = 0;
  std::optional<TrajectoryPose> after;  ///< the estimate after its last pair, if it goes on

  std::size_t size() const { return truth.size(); }
  bool inOnePiece(std::size_t from, std::size_t to) const { return piece[from] == piece[to]; }
  /// The share of the truth that has a tracked pose.
  double coverage() const {
    const auto tracked = std::ranges::count(estimate, true, &TrajectoryPose::tracked);
    return static_cast<double>(tracked) / static_cast<double>(truth_total);
  }
};

enum class MatchRule : std::uint8_t {
  Order,        ///< equal frame numbers
  Nearest,      ///< nearest in time, the nearest pairs first, each pose once
  Shorter,      ///< for each pose of the shorter file the nearest of the other, which may repeat
  Each,         ///< for each estimate the nearest truth, which may repeat; of two equally near ones
                ///< the one that a bisection meets first
  Interpolate,  ///< the truth at the time of each estimate, between two of its poses
};
inline constexpr std::array<std::string_view, 5> kMatchRuleNames = {"order", "nearest", "shorter",
                                                                    "each", "interpolate"};
constexpr std::span<const std::string_view> enumNames(MatchRule) { return kMatchRuleNames; }

struct Matching {
  MatchRule rule = MatchRule::Order;
  std::int64_t limit_ns = 0;  ///< largest difference; of Interpolate the longest gap of the truth
};

/// InvalidInput says which of the two is empty, or that nothing matches.
Result<Matches> associate(const Trajectory& truth, const Trajectory& estimate,
                          const Matching& matching);
/// By equal frame numbers.
Result<Matches> associateByFrame(const Trajectory& truth, const Trajectory& estimate);

/// How far apart in time poses may be that belong together, unless the user states it: half of the
/// shorter usual step of the two, and at least 20 ms. -1, by frame index, if one of them has no
/// stamps, or if their clocks have no moment in common.
std::int64_t usualDifference(const Trajectory& truth, const Trajectory& estimate);

/// The longest gap between two true poses over which they are interpolated, unless the user states
/// it: 2.5 usual steps, at least 0.1 s.
std::int64_t usualGap(const Trajectory& truth);

// Aligns an estimate with the truth (S. Umeyama, "Least-squares estimation of
// transformation parameters between two point patterns", PAMI 13(4), 1991).

enum class Alignment : std::uint8_t {
  None,    ///< both have the same coordinate frame
  Se2,     ///< rotation about the y axis and shift in the x-z plane, those of the first camera
  Se3,     ///< rigid motion, no scale: for stereo
  Sim3,    ///< rigid motion and scale: for a single camera
  Origin,  ///< the first poses coincide
  Yaw,     ///< shift and rotation about the vertical: for odometry that measures gravity
};
inline constexpr std::array<std::string_view, 6> kAlignmentNames = {"none", "se2",    "se3",
                                                                    "sim3", "origin", "yaw"};
constexpr std::span<const std::string_view> enumNames(Alignment) { return kAlignmentNames; }

/// The scale of the estimate; Sim3 fits it in any case.
enum class ScaleRule : std::uint8_t {
  Keep,  ///< lengths are compared as they are
  Fit,   ///< the one with the smallest errors under the alignment
  Sim3,  ///< that of the Sim(3) alignment, whatever the alignment
};
inline constexpr std::array<std::string_view, 3> kScaleRuleNames = {"keep", "fit", "sim3"};
constexpr std::span<const std::string_view> enumNames(ScaleRule) { return kScaleRuleNames; }

struct AlignmentRule {
  Alignment kind = Alignment::Se3;
  ScaleRule scale = ScaleRule::Keep;
  std::size_t first = 0;  ///< only this many pairs from the first on are aligned; 0: all
  Eigen::Vector3d vertical = Eigen::Vector3d::UnitY();  ///< of Yaw
};

/// x_truth = scale * R * x_estimate + t.
struct Similarity {
  double scale = 1;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  Eigen::Isometry3d apply(const Eigen::Isometry3d& T_world_camera) const;
};

/// The similarity of this kind that minimises the squared distances between the positions of
/// estimate and truth. R is always a proper rotation. Where positions do not determine it, it is
/// that of the first pair of orientations (one pose) or the smallest one (a straight line).
/// InvalidInput where the scale is undetermined because one side does not move.
Result<Similarity> align(const Matches& matches, const AlignmentRule& rule);
inline Result<Similarity> align(const Matches& matches, Alignment kind) {
  return align(matches, AlignmentRule{kind});
}

/// The matches with the estimate transformed into the coordinates of the truth.
Matches aligned(const Matches& matches, const Similarity& similarity);

}  // namespace tolman::evaluation
