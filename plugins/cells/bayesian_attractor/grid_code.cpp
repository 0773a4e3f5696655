// SPDX-License-Identifier: BSD-3-Clause
#include "grid_code.hpp"

#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor {

GridCode::GridCode(double period, int modules, double phase_sigma)
    : axis_(period, modules, phase_sigma), phase_sigma_(phase_sigma) {}

void GridCode::move(Phases& phases, const Eigen::Vector2d& step) const {
  for (int i = 0; i < modules(); ++i) {
    phases(0, i) = wrapPeriod(phases(0, i) + step.x(), period(i));
    phases(1, i) = wrapPeriod(phases(1, i) + step.y(), period(i));
  }
}

Eigen::Vector2d GridCode::displacement(const Phases& from, const Phases& to) const {
  const Phases difference = to - from;
  return {axis_.displacement(difference.row(0).transpose().array()),
          axis_.displacement(difference.row(1).transpose().array())};
}

}  // namespace tolman::bayesian_attractor
