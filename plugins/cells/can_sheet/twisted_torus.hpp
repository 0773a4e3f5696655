// SPDX-License-Identifier: BSD-3-Clause
// The twisted torus of Guanella, Kiper, Verschure (2007): the plane modulo a hexagonal lattice.
// A phase has two components in [0, 1) along two axes of the lattice, 60 degrees apart. Distances
// are in periods, the distance between neighbouring fields.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tolman/geometry.hpp"

namespace tolman::can_sheet {

using Phase = Eigen::Vector2d;

/// The displacement in the plane, in periods, of a difference of phases.
inline Eigen::Vector2d toPlane(const Phase& difference) {
  return {difference.x() + 0.5 * difference.y(), std::numbers::sqrt3 / 2 * difference.y()};
}

/// The difference of phases of a displacement in periods.
inline Phase toPhase(const Eigen::Vector2d& displacement) {
  const double v = displacement.y() * 2 / std::numbers::sqrt3;
  return {displacement.x() - 0.5 * v, v};
}

inline Phase wrapped(const Phase& phase) {
  return {wrapPeriod(phase.x(), 1), wrapPeriod(phase.y(), 1)};
}

/// The shortest displacement, in periods, with this difference of phases modulo 1. Its length is
/// the paper's distance, the minimum over the periodic images of a unit.
inline Eigen::Vector2d shortest(const Phase& difference) {
  const Phase near(std::remainder(difference.x(), 1), std::remainder(difference.y(), 1));
  Eigen::Vector2d best = toPlane(near);
  for (const double u : {-1.0, 0.0, 1.0}) {
    for (const double v : {-1.0, 0.0, 1.0}) {
      const Eigen::Vector2d image = toPlane(near + Phase(u, v));
      if (image.squaredNorm() < best.squaredNorm()) best = image;
    }
  }
  return best;
}

}  // namespace tolman::can_sheet
