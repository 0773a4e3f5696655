// SPDX-License-Identifier: BSD-3-Clause
// Signs that a chain of planar motions is not in metres and radians.
#pragma once

#include <string>
#include <vector>

#include "tolman/geometry.hpp"

namespace tolman::motion_log {

/// One text, without the name of the file, for angles and for lengths that no vehicle has at `rate`
/// poses a second (Hz). A few wild steps are no sign, as odometry has them; they are for `checks`.
std::vector<std::string> unitDoubts(const std::vector<PlanarPose>& poses, double rate);

}  // namespace tolman::motion_log
