// SPDX-License-Identifier: BSD-3-Clause
// Reads trajectory files, TUM and KITTI. Errors are InvalidInput and start with file:line.
#pragma once

#include <filesystem>

#include "evaluation/trajectory.hpp"
#include "tolman/status.hpp"

namespace tolman::evaluation {

/// The first line with numbers determines the format: eight numbers are TUM, twelve are KITTI. A
/// byte order mark at the begin of the file is ignored.
///
/// TUM: lines `stamp tx ty tz qx qy qz qw` (s, m), '#' starts a comment. Frames are counted from 0
/// over the lines with poses. Stamps must grow; decimal stamps are read exactly to the nanosecond.
///
/// KITTI: the upper 3x4 of T_world_camera row by row. Frame = line from 0; stamps are unknown and
/// 0.
Result<Trajectory> readTrajectory(const std::filesystem::path& file);

}  // namespace tolman::evaluation
