// SPDX-License-Identifier: BSD-3-Clause
// Positions on the plane as phases of several grid modules.
//
// A grid module of period p represents a position by its remainder modulo p along x and y: a point
// on a square torus (arXiv:2003.03091). One module cannot tell places one period apart from each
// other. Modules of different periods together can, over a range that grows exponentially with
// their number (residue code; Fiete, Burak, Brookings 2008). Lengths are in m.
#pragma once

#include <Eigen/Core>

namespace tolman::bayesian_attractor {

/// Most modules that a code may have.
inline constexpr int kMaxModules = 8;

/// One column a module: x and y, m in [0, period).
using Phases = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, kMaxModules>;

class GridCode {
 public:
  /// Module i has the period `period` * 1.42^i. A phase is read with a standard deviation of
  /// `phase_sigma` periods.
  GridCode(double period, int modules, double phase_sigma);

  int modules() const { return static_cast<int>(periods_.size()); }
  double period(int module) const { return periods_(module); }
  Phases origin() const { return Phases::Zero(2, modules()); }

  /// Path integration: all modules move by the same step.
  void move(Phases& phases, const Eigen::Vector2d& step) const;
  /// The shortest displacement that explains the difference of all phases within their errors.
  Eigen::Vector2d displacement(const Phases& from, const Phases& to) const;
  /// Standard deviation with which the modules together read a displacement, m per axis.
  double sigma() const { return sigma_; }
  double phaseSigma() const { return phase_sigma_; }

 private:
  using Residues = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxModules, 1>;
  double decode(const Residues& residues) const;

  Residues periods_;  ///< m, ascending
  Residues weights_;  ///< 1 / m^2: precision of each module
  double phase_sigma_;
  double sigma_;
};

}  // namespace tolman::bayesian_attractor
