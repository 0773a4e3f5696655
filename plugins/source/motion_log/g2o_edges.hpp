// SPDX-License-Identifier: BSD-3-Clause
// Reads pose graphs (g2o; m, rad) of one drive, planar or spatial, and what of them is odometry.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tolman/context.hpp"
#include "tolman/geometry.hpp"
#include "tolman/status.hpp"

namespace tolman::motion_log {

/// EDGE_SE2 or EDGE_SE3:QUAT. Its information matrix is checked, but not used.
struct Edge {
  std::int64_t from = 0;
  std::int64_t to = 0;
  PlanarPose motion;  ///< pose of `to` in the coordinates of `from`
  int line = 0;
};

struct GraphFile {
  std::vector<Edge> edges;
  std::map<std::int64_t, PlanarPose> vertices;  ///< poses, usually an initial guess
  std::vector<Finding> findings;                ///< how it was read, and what is not used
};

/// All poses and edges between poses. Edges of other kinds (landmarks) are counted in the findings;
/// FIX, parameters and comments are passed over. Spatial graphs become planar: x, y and yaw, or,
/// where the drive is mainly along z, those of camera axes. InvalidInput, with file, line and
/// remedy, for any other line, for missing, superfluous or too large numbers (above 1e9), for
/// negative ids, and for an information matrix that is not positive definite.
Result<GraphFile> readGraph(const std::filesystem::path& file);

/// A drive: its frames are the poses of a graph in the order of their ids.
struct Drive {
  std::vector<std::int64_t> ids;  ///< of the frames, ascending
  std::vector<PlanarPose> poses;  ///< by odometry; pose 0 is the identity
  std::vector<Edge> others;       ///< edges that are no odometry: loop candidates
  std::vector<Finding> findings;
};

/// The first edge between two successive frames, in either direction, is the odometry. Where there
/// is none, the vertices give the motion; without them, InvalidInput.
Result<Drive> readDrive(const std::filesystem::path& file);

/// One text, without the name of the file, for angles and for lengths that no vehicle has at `rate`
/// poses a second (Hz): signs of degrees and mm. A few wild steps are no sign, as odometry has
/// them; they are for `checks`.
std::vector<std::string> unitDoubts(const std::vector<PlanarPose>& poses, double rate);

}  // namespace tolman::motion_log
