// SPDX-License-Identifier: BSD-3-Clause
// Fits a square lattice to a firing rate map by its Fourier transform, as Krupic, Burgess and
// O'Keefe do for grid cells ("Neural representations of location composed of spatially periodic
// bands", Science 337, 2012). Unlike an autocorrelogram it needs no uniform coverage of the plane.
#pragma once

#include <optional>

#include "evaluation/firing_rate.hpp"

namespace tolman::report {

/// The square lattice that a rate map follows best.
struct Periodicity {
  /// min(|F(k)|, |F(k rotated by 90 deg)|) / sum of rates, F of the rates minus their mean: 1 for
  /// points on a square lattice, 0 for a unit that fires everywhere, in bands or on a hexagonal
  /// lattice. A unit with few fields has a score near 1 as well: compare with Neurons::chance.
  double score = 0;
  double spacing = 0;    ///< m
  double direction = 0;  ///< rad in [0, pi/2), of one axis, from right towards forward
};

/// Tries spacings from 4 bins to two thirds of the map's shorter side. None for a narrower map, and
/// for a unit that never fires.
std::optional<Periodicity> squarePeriodicity(const evaluation::RateMap& map);

}  // namespace tolman::report
