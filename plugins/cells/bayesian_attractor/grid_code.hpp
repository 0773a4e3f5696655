// SPDX-License-Identifier: BSD-3-Clause
// Positions on the plane as phases of several grid modules.
//
// A grid module represents a position by its remainders along x and y: a point on a square torus
// (arXiv:2003.03091). The residue codes of both coordinates are the same. Lengths are in m.
#pragma once

#include <Eigen/Core>

#include "residue_code.hpp"

namespace tolman::bayesian_attractor {

/// One column for each module: x and y, m in [0, period).
using Phases = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, kMaxModules>;

class GridCode {
 public:
  /// The same modules along x and y. Arguments as for ResidueCode, in m and periods.
  GridCode(double period, int modules, double phase_sigma);

  int modules() const { return axis_.modules(); }
  double period(int module) const { return axis_.period(module); }
  Phases origin() const { return Phases::Zero(2, modules()); }

  /// Path integration: all modules move by the same step.
  void move(Phases& phases, const Eigen::Vector2d& step) const;
  /// The shortest displacement that explains the difference of all phases within their errors.
  Eigen::Vector2d displacement(const Phases& from, const Phases& to) const;
  /// Standard deviation with which the modules together read a displacement, m per axis.
  double sigma() const { return axis_.sigma(); }
  double phaseSigma() const { return phase_sigma_; }

 private:
  ResidueCode axis_;
  double phase_sigma_;
};

}  // namespace tolman::bayesian_attractor
