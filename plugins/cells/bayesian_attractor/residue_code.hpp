// SPDX-License-Identifier: BSD-3-Clause
// One coordinate as phases of several periodic modules.
//
// A module of period p represents a coordinate by its remainder modulo p and cannot distinguish
// places one period apart from each other. Modules of different periods together can, over a range
// that grows exponentially with their number (residue code; Fiete, Burak, Brookings 2008). Lengths
// are in m.
#pragma once

#include <Eigen/Core>

namespace tolman::bayesian_attractor {

/// Most modules that a code may have. Bounds the memory of its phases.
inline constexpr int kMaxModules = 8;

/// Phases of one coordinate, one entry for each module: m, in [0, period).
using Residues = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxModules, 1>;

class ResidueCode {
 public:
  /// Module i has the period `period` * 1.42^i. A phase is read with a standard deviation of
  /// `phase_sigma` periods.
  ResidueCode(double period, int modules, double phase_sigma);

  int modules() const { return static_cast<int>(periods_.size()); }
  double period(int module) const { return periods_(module); }
  /// The shortest displacement that explains these differences of phases within their errors.
  double displacement(const Residues& differences) const;
  /// Standard deviation with which the modules together read a displacement, m.
  double sigma() const { return sigma_; }

 private:
  Residues periods_;  ///< m, ascending
  Residues weights_;  ///< 1 / m^2: precision of each module
  double sigma_;
};

}  // namespace tolman::bayesian_attractor
