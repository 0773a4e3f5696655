// SPDX-License-Identifier: BSD-3-Clause
// A Gaussian activity bump on a ring (one axis) or torus (two axes), and how two bumps combine.
//
// Equations are numbered as in arXiv:2003.03091 in order of appearance: (1) bump, (2) global
// inhibition, (3) mutual inhibition, (4) path integration, (5) injection, (6) phase estimation,
// (7) bump on the torus.
#pragma once

#include <Eigen/Core>

#include "tolman/geometry.hpp"

namespace tolman::paper_attractor {

/// A place on the manifold, each axis in [0, period).
template <int Axes>
using Phase = Eigen::Array<double, Axes, 1>;

template <int Axes>
Phase<Axes> wrapped(const Phase<Axes>& phase, double period) {
  return phase.unaryExpr([period](double value) { return wrapPeriod(value, period); });
}

/// Shortest difference from one phase to another, each axis in [-period / 2, period / 2).
template <int Axes>
Phase<Axes> shortWay(const Phase<Axes>& from, const Phase<Axes>& to, double period) {
  const Phase<Axes> ahead = to - from + period / 2;
  return wrapped<Axes>(ahead, period) - period / 2;
}

/// Length of the shortest difference.
template <int Axes>
double distance(const Phase<Axes>& a, const Phase<Axes>& b, double period) {
  return shortWay<Axes>(a, b, period).matrix().norm();
}

/// Equations (1) and (7): mean and precision 1 / sigma^2, the same on both axes of the torus
/// because both always get the same energy.
template <int Axes>
struct PeriodicBump {
  Phase<Axes> mean = Phase<Axes>::Zero();
  double precision = 0;
};

/// Equations (5) and (6): precisions add, the mean is the precision-weighted one. The paper
/// averages the means as they are. Where they are on two sides of the wrap that average is wrong by
/// half a period, so `b` is first unwrapped to within half a period of `a`.
template <int Axes>
PeriodicBump<Axes> combined(const PeriodicBump<Axes>& a, const PeriodicBump<Axes>& b,
                            double period) {
  PeriodicBump<Axes> sum;
  sum.precision = a.precision + b.precision;
  const double share = sum.precision > 0 ? b.precision / sum.precision : 0.0;
  const Phase<Axes> mean = a.mean + share * shortWay<Axes>(a.mean, b.mean, period);
  sum.mean = wrapped<Axes>(mean, period);
  return sum;
}

}  // namespace tolman::paper_attractor
