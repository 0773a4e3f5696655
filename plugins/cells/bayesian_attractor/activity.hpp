// SPDX-License-Identifier: BSD-3-Clause
// Firing rates of single units, for recorder and viewers. The network itself needs none.
//
// A unit has a preferred phase. Its rate is the expected value of its tuning curve under the bumps
// of the integrator and of the hypotheses, each weighted by its share of the energy; at most 1.
#pragma once

#include <vector>

#include "bump_network.hpp"
#include "tolman/fields.hpp"

namespace tolman::bayesian_attractor {

/// Appends
/// - hd.activity: head direction units;
/// - grid.activity, grid2.activity, ...: grid units of each module (rows y, columns x);
/// - hypotheses: the integrator, then the calibration bumps, with their shares of the energy;
/// - position.decoded: the integrator's position from the origin as all modules read it;
/// - position.sigma: its standard deviations since the last calibration.
void appendArrays(const BumpNetwork& network, std::vector<NamedArray>& arrays);
void describeArrays(const BumpNetwork& network, std::vector<ArrayInfo>& arrays);

}  // namespace tolman::bayesian_attractor
