// SPDX-License-Identifier: BSD-3-Clause
// Points of the unit cube for random and Sobol' sweeps.
#pragma once

#include <cstdint>
#include <vector>

namespace tolman::experiment {

inline constexpr std::size_t kSobolDimensions = 10;

/// The first points of Sobol's sequence in the order of the Gray code (Antonov and Saleev 1979),
/// with the direction numbers of Joe and Kuo (2008). At most kSobolDimensions dimensions.
std::vector<std::vector<double>> sobolPoints(std::size_t count, std::size_t dimensions);

/// Independent uniform points.
std::vector<std::vector<double>> randomPoints(std::size_t count, std::size_t dimensions,
                                              std::uint64_t seed);

}  // namespace tolman::experiment
