// SPDX-License-Identifier: BSD-3-Clause
// A small motion log: two laps of a square of 200 m, with loop candidates on the second lap.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tolman::test {

/// Writes odometry.g2o, ground_truth.g2o and loop_candidates.g2o; `bend` (rad) is added to each
/// turn of the odometry, so that other logs can be made.
void writeMotionFolder(const std::filesystem::path& folder, double bend = 0.002);

/// A configuration on such a log; returns its path. No neural arrays, no report.
std::filesystem::path writeMotionConfig(const std::filesystem::path& folder,
                                        const std::filesystem::path& log);

}  // namespace tolman::test
