// SPDX-License-Identifier: BSD-3-Clause
// What a physiologist would measure on a unit: where it fires, which way the head points when it
// fires, and how much that tells.
#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

namespace tolman::report {

inline constexpr double kDegrees = 180 / std::numbers::pi;  ///< in a radian

/// One visit of a place: where, which way, and how strongly the unit fired.
struct Sample {
  Eigen::Vector2d position;  ///< m, right and forward
  double heading = 0;        ///< rad, positive to the left
  double rate = 0;
};

/// Mean rate in square bins of the plane.
struct RateMap {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< m, of bin (0, 0)
  double bin = 1;                                    ///< m
  Eigen::MatrixXd rate;                              ///< (right, forward); NaN where nobody was
  Eigen::MatrixXd visits;
};
RateMap rateMap(const std::vector<Sample>& samples, int bins_on_the_long_side);
/// The highest rate of all bins; 0 without any.
double highestRate(const RateMap& map);

/// Mean rate by heading, in bins from 0 on; 0 where the head never pointed.
struct TuningCurve {
  std::vector<double> rate;
  /// Length and direction of the mean vector of the curve: 1 for one direction only, 0 for none.
  double mean_vector_length = 0;
  double preferred = 0;  ///< rad in [0, 2 pi)
};
TuningCurve tuningCurve(const std::vector<Sample>& samples, int bins);

/// Bits that the rate tells of the place (Skaggs et al., "An information-theoretic approach to
/// deciphering the hippocampal code", NIPS 1992): sum of p_i r_i/r log2(r_i/r).
double spatialInformation(const RateMap& map);

/// The centres, weighted by rate, of all fields: bins that touch and fire above `share` of the
/// highest rate. A fifth of the peak is where physiologists end a field.
std::vector<Eigen::Vector2d> fields(const RateMap& map, double share = 0.2);

}  // namespace tolman::report
