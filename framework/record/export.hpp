// SPDX-License-Identifier: BSD-3-Clause
// The files of a run for other programs: trajectories in the text formats of TUM and KITTI, and the
// map as a g2o file. Equal poses give equal bytes on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "record/run_reader.hpp"

namespace tolman::record {

/// All files that exportRun() can write, in this order.
inline constexpr std::array<std::string_view, 5> kExportedFiles = {
    "odometry.tum", "odometry.kitti", "trajectory.tum", "trajectory.kitti", "map.g2o"};

/// Writes kExportedFiles into `folder`, each atomically; the folder must exist. `trajectory` is
/// that of the map. Trajectories are those of one session (-1: the last), because the stamps of
/// different sessions may be of different clocks. Files that would be empty (a run without a map)
/// are left out. Returns the written files; InvalidInput if the record has nothing to export.
Result<std::vector<std::filesystem::path>> exportRun(const RunReader& reader,
                                                     const std::filesystem::path& folder,
                                                     std::int64_t session = -1);
Result<std::vector<std::filesystem::path>> exportRun(const std::filesystem::path& run_directory,
                                                     const std::filesystem::path& folder,
                                                     std::int64_t session = -1);

/// The shortest text that reads back as exactly this double; no negative zero.
std::string numberText(double value);

/// Seconds with nine decimals.
std::string secondsText(std::int64_t time_ns);

/// Lines `stamp tx ty tz qx qy qz qw` with qw >= 0; the stamp has nine decimals, exactly as
/// recorded.
std::string tumText(const evaluation::Trajectory& poses);

/// Twelve numbers per line, one line per frame from frame 0. The format has no frame numbers: a
/// frame without a pose repeats the previous pose (the identity before the first), so that line
/// numbers are frame numbers; so do those after the last pose up to `frames`.
std::string kittiText(const evaluation::Trajectory& poses, std::int64_t frames = 0);

/// The connected components of an experience graph. A map has several when no loop joins a session
/// with the earlier ones, or when tracking restarted at an unknown pose. The relative pose of two
/// components is unknown.
struct GraphParts {
  std::vector<std::int64_t> of_experience;  ///< component of each experience; the first one is 0
  std::int64_t count = 0;
};

/// The components that all links form that the map has not rejected.
GraphParts partsOf(const MapGraph& graph);

/// The information matrix of an EDGE_SE3:QUAT: g2o's error is (translation, vector part of the
/// quaternion), and that vector is half the rotation vector. Variances below 1e-10 (10 um, 10 urad)
/// are raised to it, so that a covariance of zero has an inverse. Scaled by the link's weight.
Matrix6d g2oInformation(const Link& link);

/// The map as VERTEX_SE3:QUAT, FIX 0, and EDGE_SE3:QUAT with the 21 values of the upper triangle.
/// Links that the map has rejected are left out.
std::string g2oText(const MapGraph& graph);

}  // namespace tolman::record
