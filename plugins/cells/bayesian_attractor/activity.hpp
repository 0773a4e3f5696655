// SPDX-License-Identifier: BSD-3-Clause
// Firing rates of single units, for recorder and viewers. The network itself does not use them.
//
// A unit has a preferred phase. Its rate is the expected value of its tuning curve under the bumps
// of the integrator and of the hypotheses, each weighted by its share (posterior probability); it
// is at most 1.
#pragma once

#include <vector>

#include "bump_network.hpp"
#include "tolman/fields.hpp"

namespace tolman::bayesian_attractor {

/// Appends
/// - hd.activity: head direction units;
/// - grid.activity, grid2.activity, ...: grid units of each module (rows y, columns x);
/// - height.activity, height2.activity, ...: units of each vertical module, if there are any;
/// - hypotheses: the integrator, then the calibration bumps; their component `energy` is the share;
/// - position.decoded: the integrator's position (m, relative to the origin) and heading (rad);
/// - position.sigma: their standard deviations since a bump was last accepted;
/// - calibration: steady errors of path integration, their standard deviations, noise;
/// - height.decoded, with vertical modules: height and its standard deviation, m.
void appendArrays(const BumpNetwork& network, std::vector<NamedArray>& arrays);
void describeArrays(const BumpNetwork& network, std::vector<ArrayInfo>& arrays);

}  // namespace tolman::bayesian_attractor
