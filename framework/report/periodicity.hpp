// SPDX-License-Identifier: BSD-3-Clause
// Is a firing-rate map a square lattice, and which? By its Fourier transform, as Krupic, Burgess
// and O'Keefe ("Neural representations of location composed of spatially periodic bands", Science
// 337, 2012) take it of grid cells: unlike an autocorrelogram it needs no ground that is covered
// all over, and roads are not.
#pragma once

#include <optional>

#include "report/firing_rate.hpp"

namespace tolman::report {

/// The square lattice that a rate map follows best.
struct Periodicity {
  /// min(|F(k)|, |F(k turned by 90 deg)|) / sum of rates, F of the rates less their mean: 1 for
  /// points on a square lattice, 0 for a unit that fires everywhere, in bands or on a hexagonal
  /// lattice. A unit of few fields comes near 1 as well: compare with the same unit by chance.
  double score = 0;
  double spacing = 0;    ///< m
  double direction = 0;  ///< rad in [0, pi/2), of one axis, from right towards forward
};

/// Spacings from 4 bins to two thirds of the map's shorter side are tried. Nothing for a map that
/// is narrower than that, and for a unit that never fires.
std::optional<Periodicity> squarePeriodicity(const RateMap& map);

}  // namespace tolman::report
