// SPDX-License-Identifier: BSD-3-Clause
// Standard measurements of single units: firing rate map, head direction tuning curve, spatial
// information and firing fields.
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <optional>
#include <vector>

namespace tolman::evaluation {

inline constexpr double kRadiansOfTurn = 2 * std::numbers::pi;  ///< rad
inline constexpr double kDegrees = 180 / std::numbers::pi;      ///< degrees per radian

/// Position, heading and rate of a unit at one frame.
struct Sample {
  Eigen::Vector2d position;  ///< m, right and forward
  double heading = 0;        ///< rad, positive to the left
  double rate = 0;
  double seconds = 1;  ///< until the next frame; 0: does not count, because it stands still
  double speed = 0;    ///< m/s
};

/// Mean rate in square bins of the plane, over time.
struct RateMap {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< m, of bin (0, 0)
  double bin = 1;                                    ///< m
  Eigen::MatrixXd rate;    ///< (right, forward); NaN in bins without visits
  Eigen::MatrixXd visits;  ///< s
};
RateMap rateMap(const std::vector<Sample>& samples, int bins_on_the_long_side);
/// Activity and time, both smoothed by a Gaussian of `sigma` bins and then divided (Hafting et al.,
/// "Microstructure of a spatial map in the entorhinal cortex", Nature 436, 2005). `visits` stay as
/// they are, and bins without visits have no rate.
RateMap smoothed(const RateMap& map, double sigma);
/// The highest rate of all bins; 0 without any.
double highestRate(const RateMap& map);

/// Mean rate by heading, in equal bins from heading 0; 0 in bins without visits.
struct TuningCurve {
  std::vector<double> rate;
  /// Length and direction of the mean vector of the curve: 1 for one direction only, 0 for none.
  double mean_vector_length = 0;
  double preferred = 0;  ///< rad in [0, 2 pi)
  /// rad, half the width at half of the peak, as of the rat's head direction cells (Taube, Muller,
  /// Ranck 1990); pi for a curve that never falls to half. Bins without visits are interpolated.
  /// None where fewer than half of all bins were visited, or without activity.
  std::optional<double> half_width;
};
TuningCurve tuningCurve(const std::vector<Sample>& samples, int bins);

/// Spatial information, bits per spike (Skaggs et al., "An information-theoretic approach to
/// deciphering the hippocampal code", NIPS 1992): sum of p_i r_i/r log2(r_i/r).
double spatialInformation(const RateMap& map);

/// The centres, weighted by rate, of all fields, m. A field is a group of adjacent bins with rates
/// above `share` of the highest rate; a fifth is a usual limit.
std::vector<Eigen::Vector2d> fields(const RateMap& map, double share = 0.2);

/// The same fields as bins: 0 outside of them, otherwise the number of the field, from 1.
struct FieldBins {
  Eigen::MatrixXi field;
  int count = 0;
};
FieldBins fieldBins(const RateMap& map, double share = 0.2);

/// Sums for Pearson's correlation.
struct Correlation {
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;

  void add(double x, double y, double weight = 1);
  double value() const;  ///< NaN where x or y is constant
};

/// (sum of p_i r_i)^2 / sum of p_i r_i^2: share of the environment where the unit fires (Skaggs et
/// al., "Theta phase precession ...", Hippocampus 6, 1996). None without activity.
std::optional<double> sparsity(const RateMap& map);

/// Fisher's z of the correlation between the rate of each bin and the mean of the bins around it
/// (Muller, Kubie, "The firing of hippocampal place cells predicts the future position of freely
/// moving rats", J. Neurosci. 9, 1989). None where the rate is the same everywhere.
std::optional<double> coherence(const RateMap& map);

/// (c - d) / (c + d) with c, the largest share of a wall that one field covers, and d, the mean
/// distance of all fields from the nearest wall, weighted by rate, as a share of half the shorter
/// side (Solstad et al., "Representation of geometric borders in the entorhinal cortex", Science
/// 322, 2008). Walls are the sides of the map; fields have more than 0.3 of the highest rate and
/// 0.02 m^2. None without fields, and where more than half of the box is free: roads have no walls.
std::optional<double> borderScore(const RateMap& map);

/// Correlation of rate and speed (Kropff et al., "Speed cells in the medial entorhinal cortex",
/// Nature 523, 2015), over the samples that count. None where one of them is constant.
std::optional<double> speedScore(const std::vector<Sample>& samples);

// Grid scores: how well the autocorrelogram of a rate map agrees with itself when it is rotated.
//
// The autocorrelogram holds, for each displacement, the correlation of the map with itself over the
// bins that both copies have visited. A ring of it, without the central peak, is rotated; r(a) is
// its correlation with itself after the angle a. It has two-fold symmetry, so r(120) = r(60),
// r(150) = r(30), and r(135) = r(45).

/// Correlation by displacement in bins, (0, 0) in the middle; NaN where too few bins overlap.
Eigen::MatrixXd autocorrelogram(const RateMap& map, int reach);

struct GridScores {
  /// r(60) - max(r(30), r(90)) of the ring of the nearest peaks: min(60, 120) - max(30, 90, 150) of
  /// Sargolini et al., "Conjunctive representation of position, direction, and velocity in
  /// entorhinal cortex", Science 312, 2006. About 1 and more for a hexagonal lattice.
  double sargolini = 0;
  /// The largest such score of all rings from the central peak to a growing radius: Langston et
  /// al., "Development of the spatial representation system in the rat", Science 328, 2010.
  double langston = 0;
  /// r(90) - r(45) of the ring of the nearest peaks: about 1 and more for a square lattice.
  double square = 0;
  double spacing = 0;  ///< m, distance of the nearest peaks
  /// rad, smallest angle of a nearest peak from the axis to the right, to the left of it.
  double orientation = 0;
  /// Longer over shorter axis of the ellipse through the nearest peaks (Krupic et al., Nature 518,
  /// 2015): 1 for a regular lattice. NaN with fewer than three pairs of peaks.
  double ellipticity = 0;
};

/// None if the map is too narrow for neighbouring fields, or if the rate is the same everywhere.
std::optional<GridScores> gridScores(const RateMap& map);

}  // namespace tolman::evaluation
