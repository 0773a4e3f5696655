// SPDX-License-Identifier: BSD-3-Clause
// Grid cells: the attractor network on a square torus, an infinite plane folded onto one period.
#pragma once

#include <cmath>

#include "attractor_network.hpp"

namespace tolman::paper_attractor {

class GridTorus : public AttractorNetwork<2> {
 public:
  GridTorus(const NetworkSettings& settings, double metres_per_cell)
      : AttractorNetwork<2>(settings), metres_per_cell_(metres_per_cell) {}

  /// Path integration of a step (m, forward and left) that began with `heading` (rad). The paper
  /// moves along the new heading; the measured step does not need its assumption of small turns.
  void move(double forward, double left, double heading) {
    integrate(toCells(forward, left, heading));
  }

  /// Displacement in cells of a step (m) in the axes of `heading` (rad).
  Phase<2> toCells(double forward, double left, double heading) const {
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    return Phase<2>(c * forward - s * left, s * forward + c * left) / metres_per_cell_;
  }

 private:
  double metres_per_cell_;
};

}  // namespace tolman::paper_attractor
