// SPDX-License-Identifier: BSD-3-Clause
#include "grid_code.hpp"

#include <cmath>
#include <limits>

#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor {
namespace {

/// Ratio of neighbouring modules' periods in the rat (Stensola et al. 2012).
constexpr double kRatio = 1.42;
/// Displacements are searched up to this many of the largest period.
constexpr int kRange = 50;
/// Squared error, per degree of freedom, up to which phases agree: three standard deviations.
constexpr double kAgreement = 9;

/// Shortest way round one period.
template <class Array>
Array shortest(const Array& difference, const Array& periods) {
  return difference - periods * (difference / periods).round();
}

}  // namespace

GridCode::GridCode(double period, int modules, double phase_sigma)
    : periods_(modules), weights_(modules), phase_sigma_(phase_sigma) {
  for (int i = 0; i < modules; ++i) periods_(i) = period * std::pow(kRatio, i);
  weights_ = (phase_sigma * periods_).square().inverse();
  sigma_ = 1 / std::sqrt(weights_.sum());
}

void GridCode::move(Phases& phases, const Eigen::Vector2d& step) const {
  for (int i = 0; i < modules(); ++i) {
    phases(0, i) = wrapPeriod(phases(0, i) + step.x(), periods_(i));
    phases(1, i) = wrapPeriod(phases(1, i) + step.y(), periods_(i));
  }
}

Eigen::Vector2d GridCode::displacement(const Phases& from, const Phases& to) const {
  const Phases difference = to - from;
  return {decode(shortest<Residues>(difference.row(0).transpose().array(), periods_)),
          decode(shortest<Residues>(difference.row(1).transpose().array(), periods_))};
}

/// Tries the displacements that fit the largest period, the shortest first.
double GridCode::decode(const Residues& residues) const {
  const Eigen::Index last = residues.size() - 1;
  const double away = residues(last) < 0 ? 1 : -1;  // the second shortest has the other sign
  double best = residues(last);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 2 * kRange; ++i) {
    const int turns = i % 2 == 1 ? (i + 1) / 2 : -i / 2;
    const double coarse = residues(last) + away * turns * periods_(last);
    const Residues rest = shortest<Residues>(residues - coarse, periods_);
    const double correction = (weights_ * rest).sum() / weights_.sum();
    const double misfit = (weights_ * (rest - correction).square()).sum();
    if (misfit >= least) continue;
    least = misfit;
    best = coarse + correction;
    if (misfit <= kAgreement * static_cast<double>(last)) break;
  }
  return best;
}

}  // namespace tolman::bayesian_attractor
