// SPDX-License-Identifier: BSD-3-Clause
// What path integration knows, and how well: dead reckoning with moments from which the covariance
// between any two moments of the past follows in constant time, and the loops closed so far as
// short cuts. It lets the cells weigh a familiar view before they believe it.
#pragma once

#include <cstdint>
#include <deque>

#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor {

/// A planar pose with the covariance of (x m, y m, theta rad), all along the axes that it is seen
/// from.
struct UncertainStep {
  PlanarPose pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// a followed by b, the errors independent; to first order.
UncertainStep chained(const UncertainStep& a, const UncertainStep& b);
UncertainStep inverse(const UncertainStep& a);

/// Systematic errors of an odometry: the same all along, unlike the noise that it reports.
struct DriftSettings {
  double heading = 1e-4;  ///< rad/m, standard deviation of a constant pull to one side
  double scale = 0.01;    ///< standard deviation of the scale
};

/// A moment of the path: the pose by dead reckoning, and sums along the way to it.
struct PathMark {
  std::int64_t step = 0;  ///< motions before it
  std::int64_t part = 0;  ///< gaps before it: between two parts dead reckoning says nothing
  PlanarPose pose;
  /// Sum of w (1, x, y, xx, xy, yy), w the variance of each turn: where turns went wrong.
  Eigen::Matrix<double, 6, 1> turns = Eigen::Matrix<double, 6, 1>::Zero();
  /// Sum of d (1, x, y), d the length of each step: what a constant pull would do.
  Eigen::Vector3d lengths = Eigen::Vector3d::Zero();
  double step_variance = 0;  ///< m^2, sum of each step's, per axis
};

/// A loop that was closed: the robot stood at `visit`, seen from where it stood at `home`.
struct ClosedLoop {
  PathMark home;
  PathMark visit;
  UncertainStep offset;
};

class PathMemory {
 public:
  explicit PathMemory(const DriftSettings& settings) : settings_(settings) {}

  /// One motion with the variances (m^2 per axis, rad^2) that odometry claims for it.
  void advance(const PlanarPose& motion, double step_variance, double turn_variance);
  const PathMark& now() const { return now_; }
  /// The robot is somewhere else now, and nobody knows where.
  void startPart() { ++now_.part; }

  /// `to` seen from `from`, in either order of time, by dead reckoning alone; of one part.
  UncertainStep between(const PathMark& from, const PathMark& to) const;
  /// Whether the present can be seen from `from`: no gap lies between, or a loop leads over it.
  bool reaches(const PathMark& from) const;
  /// The present seen from `from`, which it reaches: directly, or over one closed loop, whichever
  /// is surest.
  UncertainStep predict(const PathMark& from) const;
  /// The same over this loop.
  UncertainStep over(const ClosedLoop& loop, const PathMark& from) const;

  /// Keeps a loop as a short cut, and forgets those that it contradicts (chi-square above `gate`).
  void close(const PathMark& home, const UncertainStep& offset, double gate);
  /// Bounding rectangle of the path with a margin on each side, m^2.
  double exploredArea(double margin) const;

  /// All that decides the future, for saving.
  struct State {
    PathMark now;
    Eigen::Vector2d least = Eigen::Vector2d::Zero();
    Eigen::Vector2d most = Eigen::Vector2d::Zero();
    std::deque<ClosedLoop> loops;
  };
  State state() const { return {now_, least_, most_, loops_}; }
  void restore(const State& state);

 private:
  bool leads(const ClosedLoop& loop, const PathMark& from) const;
  void forgetOne();

  DriftSettings settings_;
  PathMark now_;
  Eigen::Vector2d least_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d most_ = Eigen::Vector2d::Zero();
  std::deque<ClosedLoop> loops_;  ///< the latest ones
};

/// Squared Mahalanobis distance of two poses seen from the same place.
double chiSquare(const UncertainStep& a, const UncertainStep& b);

}  // namespace tolman::bayesian_attractor
