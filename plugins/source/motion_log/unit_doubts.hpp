// SPDX-License-Identifier: BSD-3-Clause
// Signs that a chain of planar motions, or loop candidates, are not in metres and radians.
#pragma once

#include <string>
#include <vector>

#include "g2o_edges.hpp"
#include "tolman/geometry.hpp"

namespace tolman::motion_log {

/// One text, without the name of the file, for angles and for lengths that no vehicle has at `rate`
/// poses a second (Hz). A few wild steps are no sign, as odometry has them; they are for `checks`.
std::vector<std::string> unitDoubts(const std::vector<PlanarPose>& poses, double rate);

/// The same for loop candidates (edges between two of `poses`, by odometry): lengths that lead
/// further than the way between the two frames or than one place can be seen, and angles that agree
/// with the odometry only if they are degrees.
std::vector<std::string> candidateDoubts(const std::vector<Edge>& candidates,
                                         const std::vector<PlanarPose>& poses);

}  // namespace tolman::motion_log
