// SPDX-License-Identifier: BSD-3-Clause
// Firing patterns of the conjunctive population, whose cells are tuned to head direction and
// position (as in layers III and V of the entorhinal cortex), and Gaussian bumps over them.
//
// A pattern is a heading on the ring, a phase on the torus of each grid module, and a phase of each
// vertical module. A bump is a Gaussian around a pattern, with covariance of (x m, y m, heading
// rad) in the axes of heading 0, and a variance of height; in heading it is the von Mises
// distribution of the same precision.
#pragma once

#include <Eigen/Core>
#include <numbers>

#include "grid_code.hpp"
#include "path_errors.hpp"
#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor {

inline constexpr double kTurn = 2 * std::numbers::pi;  // rad

struct FiringPattern {
  double heading = 0;  ///< rad in [0, 2 pi)
  Phases phases;
  Residues heights;
};

struct Bump {
  FiringPattern centre;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double height_variance = 0;  ///< m^2
  PathErrors errors = {};      ///< of path integration on the way to the centre
};

class ConjunctiveCode {
 public:
  /// Without vertical modules the code is that of a plane.
  explicit ConjunctiveCode(const GridCode& grid, const HeightCode& height = {1, 0, 1})
      : grid_(grid), height_(height) {}

  const GridCode& grid() const { return grid_; }
  const HeightCode& height() const { return height_; }
  /// Covariance of the error with which ring and modules read a pattern.
  Eigen::Matrix3d readout() const;
  FiringPattern origin() const { return {0, grid_.origin(), height_.origin()}; }

  /// `pattern` after a step that is given in the robot's own axes, and a climb in m.
  FiringPattern displaced(const FiringPattern& pattern, const PlanarPose& step,
                          double climb = 0) const;
  /// The displacement (x, y, heading) from one pattern to another, in the axes of heading 0, as the
  /// modules read it.
  Eigen::Vector3d difference(const FiringPattern& from, const FiringPattern& to) const;
  /// The pose of `to` in the axes of `from`.
  PlanarPose between(const FiringPattern& from, const FiringPattern& to) const;
  /// Climb in m from one pattern to another, as the vertical modules read it.
  double climb(const FiringPattern& from, const FiringPattern& to) const;

  /// Path integration: moves the bump, propagates its variance of heading to position, and adds
  /// `noise`, the covariance of the step, and `errors`, both in the robot's own axes.
  void move(Bump& bump, const PlanarPose& step, const Eigen::Matrix3d& noise,
            const Climb& climb = {}, const PathErrors& errors = {}) const;
  /// Moves the centre by (x m, y m, heading rad) in the axes of heading 0.
  void shift(FiringPattern& pattern, const Eigen::Vector3d& by) const;
  /// Multiplies the bump by a Gaussian: precisions add (the paper's equation of injection, with
  /// matrices).
  void fuse(Bump& bump, const FiringPattern& seen, const Eigen::Matrix3d& covariance,
            double height_variance = 0) const;

 private:
  GridCode grid_;
  HeightCode height_;
};

/// `covariance` of (x, y, heading) after a rotation by `angle`.
Eigen::Matrix3d turned(const Eigen::Matrix3d& covariance, double angle);
/// Derivative of the pose (x, y, heading) after a displacement (m, axes of heading 0) with respect
/// to the pose before it.
Eigen::Matrix3d displacementJacobian(const Eigen::Vector2d& displacement);
/// The matrix with the same eigenvectors and the absolute values of the eigenvalues.
Eigen::Matrix3d absolute(const Eigen::Matrix3d& symmetric);
/// d' S^-1 d, with the chord instead of the arc in heading, as in the von Mises distribution.
double squaredMahalanobis(const Eigen::Vector3d& difference, const Eigen::Matrix3d& covariance);

}  // namespace tolman::bayesian_attractor
