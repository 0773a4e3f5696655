// SPDX-License-Identifier: BSD-3-Clause
// Points and keyframes that leave the window and stay behind as a quadratic energy.
#pragma once

#include <vector>

#include "linear_system.hpp"

namespace tolman::direct_sparse {

/// Which keyframes are to leave: those that have hardly any points left or another brightness, and
/// where there are still more than `most`, the one that adds least to an even spread (algorithms:
/// 5.7). The two newest stay.
std::vector<int> chooseLeaving(const Window& window, int most);

/// Turns points hosted by leaving keyframes, and points that the two latest keyframes do not see,
/// into terms of the window's prior, linearised at the first estimates; bad ones are dropped.
void marginalisePoints(const CameraRig& rig, const SystemSettings& settings,
                       const std::vector<int>& leaving, double weight, Window& window,
                       LinearSystem& system);

/// Eliminates the variables of the slot from the prior and removes the keyframe.
void marginaliseKeyframe(int slot, Window& window);

}  // namespace tolman::direct_sparse
