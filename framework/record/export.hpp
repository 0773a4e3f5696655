// SPDX-License-Identifier: BSD-3-Clause
// Writes the result files from run.sqlite alone, at the end of a run or after a kill.
#pragma once

#include <array>
#include <filesystem>
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

}  // namespace tolman::record
