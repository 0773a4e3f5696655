// SPDX-License-Identifier: BSD-3-Clause
// Reads the planar edges (EDGE_SE2; m, rad) of a g2o file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tolman/geometry.hpp"
#include "tolman/status.hpp"

namespace tolman::motion_log {

/// EDGE_SE2 from to dx dy dtheta and six information values, which are checked but not used.
struct Edge {
  std::int64_t from = 0;
  std::int64_t to = 0;
  PlanarPose motion;  ///< pose of `to` in the coordinates of `from`
  int line = 0;
};

/// All EDGE_SE2 of the file. Vertices, FIX and comments are ignored. InvalidInput, with file, line
/// and remedy, for any other line, for missing, superfluous or too large numbers (above 1e9), for
/// negative ids, and for an information matrix that is not positive definite.
Result<std::vector<Edge>> readEdges(const std::filesystem::path& file);

/// Poses 0 ... n from edges that must be (0, 1), (1, 2), ... in this order; pose 0 is the identity.
Result<std::vector<PlanarPose>> readChain(const std::filesystem::path& file);

/// One text, without the name of the file, for angles and for lengths that no vehicle has at `rate`
/// poses a second (Hz): signs of degrees and mm. A few wild steps are no sign, as odometry has
/// them; they are for `checks`.
std::vector<std::string> unitDoubts(const std::vector<PlanarPose>& poses, double rate);

}  // namespace tolman::motion_log
