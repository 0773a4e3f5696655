// SPDX-License-Identifier: BSD-3-Clause
// Whether the distance of two cameras can be meant: a wrong unit gives a map of the wrong scale.
#pragma once

#include <string>

#include "tolman/camera.hpp"

namespace tolman::imaging {

/// What to look at where a baseline is below 1 cm or above 10 m; empty for others and for a single
/// camera.
std::string baselineDoubt(const CameraRig& rig);

}  // namespace tolman::imaging
