// SPDX-License-Identifier: BSD-3-Clause
#include "height_code.hpp"

#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor {

void HeightCode::move(Residues& heights, double climb) const {
  for (int i = 0; i < modules(); ++i) heights(i) = wrapPeriod(heights(i) + climb, period(i));
}

double HeightCode::difference(const Residues& from, const Residues& to) const {
  return modules() > 0 ? code_.displacement(to - from) : 0;
}

}  // namespace tolman::bayesian_attractor
