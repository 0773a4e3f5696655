// SPDX-License-Identifier: BSD-3-Clause
#include "grid_code.hpp"

#include <cmath>
#include <limits>

#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor {
namespace {

/// Ratio of neighbouring modules' periods in the rat (Stensola et al. 2012).
constexpr double kRatio = 1.42;
/// Displacements are searched up to this many times the largest period: 21 km with the default
/// modules. Bounds the time.
constexpr int kRange = 50;
/// Squared error in standard deviations, per degree of freedom, up to which phases agree: three.
constexpr double kAgreement = 9;

/// Shortest way round one period.
Residues shortest(const Residues& difference, const Residues& periods) {
  return difference - periods * (difference / periods).round();
}

}  // namespace

ResidueCode::ResidueCode(double period, int modules, double phase_sigma)
    : periods_(modules), weights_(modules) {
  for (int i = 0; i < modules; ++i) periods_(i) = period * std::pow(kRatio, i);
  weights_ = (phase_sigma * periods_).square().inverse();
  sigma_ = 1 / std::sqrt(weights_.sum());
}

/// Tries the displacements that fit the largest period, the shortest first.
double ResidueCode::displacement(const Residues& differences) const {
  const Residues residues = shortest(differences, periods_);
  const Eigen::Index last = residues.size() - 1;
  const double away = residues(last) < 0 ? 1 : -1;  // the second shortest has the other sign
  double best = residues(last);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 2 * kRange; ++i) {
    const int turns = i % 2 == 1 ? (i + 1) / 2 : -i / 2;
    const double coarse = residues(last) + away * turns * periods_(last);
    const Residues rest = shortest(residues - coarse, periods_);
    const double correction = (weights_ * rest).sum() / weights_.sum();
    const double misfit = (weights_ * (rest - correction).square()).sum();
    if (misfit >= least) continue;
    least = misfit;
    best = coarse + correction;
    if (misfit <= kAgreement * static_cast<double>(last)) break;
  }
  return best;
}

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

void HeightCode::move(Residues& heights, double climb) const {
  for (int i = 0; i < modules(); ++i) heights(i) = wrapPeriod(heights(i) + climb, period(i));
}

double HeightCode::difference(const Residues& from, const Residues& to) const {
  return modules() > 0 ? code_.displacement(to - from) : 0;
}

}  // namespace tolman::bayesian_attractor
