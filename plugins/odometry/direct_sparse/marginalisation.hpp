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

/// Takes from the prior what it says of the window as a whole: where it is, how bright it is. That
/// is nothing but rounding of floats, but it adds up over a long drive, and once it outweighs what
/// is left of the start, the window is free to jump.
void forgetGauge(Window& window);

}  // namespace tolman::direct_sparse
