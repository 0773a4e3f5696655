// SPDX-License-Identifier: BSD-3-Clause
// A generated KITTI folder of tiny images, and configurations that run on it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "end_to_end/process.hpp"

namespace tolman::test {

/// Writes `frames` stereo pairs of 160x60 px of seeded texture that wanders slowly, calib.txt,
/// times.txt and poses.txt (straight ahead at 10 m/s).
void writeTinyKitti(const std::filesystem::path& folder, int frames);

/// A configuration on that folder whose odometry needs no texture (a fixture plugin).
std::filesystem::path writeTinyConfig(const std::filesystem::path& folder,
                                      const std::filesystem::path& sequence);

/// Arguments of `tolman run` for it, with the fixture plugins on the search path.
std::vector<std::string> tinyRun(const std::filesystem::path& config,
                                 const std::filesystem::path& out);

}  // namespace tolman::test
