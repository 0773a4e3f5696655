// SPDX-License-Identifier: BSD-3-Clause
// Reads trajectory files: TUM, KITTI, KITTI-360, EuRoC, and tables with named columns. Errors are
// InvalidInput and start with file:line.
#pragma once

#include <filesystem>

#include "evaluation/trajectory.hpp"
#include "tolman/status.hpp"

namespace tolman::evaluation {

/// A line of names before the numbers names the columns ("stamp_ns, x, y, z, qw, ..."; a comment
/// does so if it has as many). Without it their count determines the format: 8 are TUM (stamp, s;
/// position, m; quaternion, w last), 12 KITTI (rows of T_world_camera), 4 a stamp and a position,
/// 13 and 17 a frame and its matrix (KITTI-360). Stamps of 16 and more digits are ns, as in EuRoC's
/// tables, where w comes first.
///
/// Stamps must grow; they are read exactly to the nanosecond. Without frames, these are counted
/// from 0; without stamps, these are 0. Positions alone have equal orientations.
Result<Trajectory> readTrajectory(const std::filesystem::path& file);

}  // namespace tolman::evaluation
