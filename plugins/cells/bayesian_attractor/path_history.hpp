// SPDX-License-Identifier: BSD-3-Clause
// The path so far, in pieces, so that it can be traced again once its steady errors are known: a
// correction of a long way is not linear in them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "path_errors.hpp"

namespace tolman::bayesian_attractor {

/// A pose of path integration (m, rad), its covariance, and the effect of errors on it.
struct Traced {
  PlanarPose pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  PathErrors errors = {};
  /// A step in the robot's axes.
  void move(const PlanarPose& step, const PathErrors& step_errors = {});
  /// The same; its covariance is added, that of heading is propagated.
  void move(const PlanarPose& step, const Eigen::Matrix3d& noise, const PathErrors& step_errors);
};

/// A piece of the path, or a jump from where an earlier piece begins: to a bump that was accepted,
/// or to the beginning of a part of the path.
struct PathPiece {
  std::int64_t origin =
      -1;                  ///< the piece at whose beginning it begins; -1: the end of the last one
  bool unknown = false;    ///< a jump to the beginning of a part whose origin is not known yet
  PlanarPose motion = {};  ///< as reported
  Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();
  ErrorEffect effect = ErrorEffect::Zero();
  double length = 0;      ///< m
  PlanarPose begin = {};  ///< as it was traced last
};

class PathHistory {
 public:
  /// Path integration by a step that was reported so and corrected to `corrected`. A piece that is
  /// longer than `spacing` ends.
  void advance(const PlanarPose& reported, const PlanarPose& corrected,
               const Eigen::Matrix3d& noise, const ErrorEffect& effect, double spacing);
  /// A part begins at the last pose.
  void startPart();
  /// The robot is at `offset` from where piece `origin` begins, with this covariance in its axes.
  void jump(std::int64_t origin, const PlanarPose& offset, const Eigen::Matrix3d& covariance);
  /// The robot is likewise at `offset` from a piece of another part: the present part joins it.
  void join(std::int64_t origin, const PlanarPose& offset, const Eigen::Matrix3d& covariance);

  /// Where each piece from `first` on begins, and last where the robot is, with these steady
  /// errors.
  std::vector<Traced> trace(const ErrorVector& errors, std::int64_t first = 0,
                            bool covariances = true) const;
  /// The first piece that the way from piece `from` to the robot depends on.
  std::int64_t firstOfWay(std::int64_t from) const;
  /// The pieces are where `trace` has them.
  void accept(const std::vector<Traced>& trace);

  std::int64_t last() const { return static_cast<std::int64_t>(pieces_.size()) - 1; }
  const PlanarPose& beginOf(std::int64_t piece) const {
    return pieces_[static_cast<std::size_t>(piece)].begin;
  }
  const std::vector<PathPiece>& pieces() const { return pieces_; }
  void restore(std::vector<PathPiece> pieces, const PlanarPose& here);
  const PlanarPose& here() const { return here_; }

 private:
  /// The piece with which the part of piece `k` begins.
  std::int64_t rootOf(std::int64_t k) const;

  std::vector<PathPiece> pieces_ = {{}};
  PlanarPose here_ = {};
};

/// A familiar view, as its template's piece of the path sees it.
struct TracedView {
  std::int64_t piece = 0;  ///< in which the template was learned
  PlanarPose pose = {};    ///< that the view puts the robot at, from where the piece begins
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the pose, axes of heading 0
};
/// What a view says of the steady errors, and how likely it is.
struct TracedLoop {
  ErrorEstimate estimate;
  double density = 0;
};
/// A Kalman step where the way may have turned by so much more than was reported that its shape is
/// another: it is traced with the present estimate, and again with what follows (an iterated
/// filter), from each turn that explains the heading. Drift has Student's distribution of `tail`
/// degrees of freedom.
TracedLoop traceLoop(const PathHistory& path, const ErrorEstimate& prior, const TracedView& view,
                     double tail);
/// Density of Student's t in three dimensions, at this squared distance in variances.
double logStudent(double squared, const Eigen::Matrix3d& covariance, double tail);

}  // namespace tolman::bayesian_attractor
