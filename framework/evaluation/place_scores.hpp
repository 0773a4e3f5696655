// SPDX-License-Identifier: BSD-3-Clause
// Scores of single units beside those of grids, each by the definition of its paper; and what of a
// walk counts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evaluation/recorded_cells.hpp"

namespace tolman::evaluation {

/// (sum of p_i r_i)^2 / sum of p_i r_i^2: the share of the environment where the unit fires (Skaggs
/// et al., "Theta phase precession in hippocampal neuronal populations", Hippocampus 6, 1996). None
/// without activity.
std::optional<double> sparsity(const RateMap& map);

/// Fisher's z of the correlation between the rate of each bin and the mean of the bins around it
/// (Muller, Kubie, "The firing of hippocampal place cells predicts the future position of freely
/// moving rats", J. Neurosci. 9, 1989). None where the rate is the same everywhere.
std::optional<double> coherence(const RateMap& map);

/// (c - d) / (c + d) with c, the largest share of a wall that one field covers, and d, the mean
/// distance of all fields from the nearest wall, weighted by rate, as a share of half the shorter
/// side (Solstad et al., "Representation of geometric borders in the entorhinal cortex", Science
/// 322, 2008). Walls are the sides of the map; fields have more than 0.3 of the highest rate and
/// 0.02 m^2. None where the walk leaves more than half of the box free (a road has no walls), and
/// without fields.
std::optional<double> borderScore(const RateMap& map);

/// Correlation of rate and speed (Kropff et al., "Speed cells in the medial entorhinal cortex",
/// Nature 523, 2015), over the samples that count. None where one of them is constant.
std::optional<double> speedScore(const std::vector<Sample>& samples);

/// Sets speeds and durations of the samples at these times, ns. A gap of more than five median
/// steps counts as one. Of an animal, which is never faster than 2 m/s, standing (slower than 2.5
/// cm/s) does not count, as usual in this field; of a vehicle it does. `metric`: positions are in
/// m.
void setTimes(RecordedUnits& units, const std::vector<std::int64_t>& stamps_ns, bool metric);

}  // namespace tolman::evaluation
