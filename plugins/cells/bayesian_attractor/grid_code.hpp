// SPDX-License-Identifier: BSD-3-Clause
// One coordinate as phases of several periodic modules.
//
// A module of period p represents a coordinate by its remainder modulo p and cannot tell places one
// period apart from each other. Modules of different periods together can, over a range that grows
// exponentially with their number (residue code; Fiete, Burak, Brookings 2008). Lengths are in m.
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

// Positions on the plane as phases of several grid modules.
//
// A grid module represents a position by its remainders along x and y: a point on a square torus
// (arXiv:2003.03091). The residue codes of both coordinates are the same. Lengths are in m.

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

// Heights as phases of periodic vertical modules: the third axis of the grid cells, as in
// NeuroSLAM (Yu et al. 2019), with a residue code instead of one period.
//
// Roads are nearly level, so errors of height hardly depend on those of position and heading: a
// bump is the product of a Gaussian on the plane and one of height. Lengths are in m, upwards.

/// The vertical part of a step, of a measured pose, or of a difference.
struct Climb {
  double metres = 0;
  double variance = 0;  ///< m^2
};

class HeightCode {
 public:
  /// Arguments as for ResidueCode, in m and periods. Without modules all heights are the same.
  HeightCode(double period, int modules, double phase_sigma)
      : code_(period, modules, phase_sigma) {}

  int modules() const { return code_.modules(); }
  double period(int module) const { return code_.period(module); }
  Residues origin() const { return Residues::Zero(modules()); }

  /// All modules move by the same climb.
  void move(Residues& heights, double climb) const;
  /// Climb from one height to another as the modules read it, m.
  double difference(const Residues& from, const Residues& to) const;
  /// Variance of the error with which the modules read a difference, m^2.
  double readout() const { return modules() > 0 ? code_.sigma() * code_.sigma() : 0; }

 private:
  ResidueCode code_;
};

}  // namespace tolman::bayesian_attractor
