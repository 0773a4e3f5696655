// SPDX-License-Identifier: BSD-3-Clause
// Heights as phases of periodic vertical modules: the third axis of the grid cells, as in
// NeuroSLAM (Yu et al. 2019), with a residue code instead of one period.
//
// Roads are nearly level, so errors of height hardly depend on those of position and heading: a
// bump is the product of a Gaussian on the plane and one of height. Lengths are in m, upwards.
#pragma once

#include "residue_code.hpp"

namespace tolman::bayesian_attractor {

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
