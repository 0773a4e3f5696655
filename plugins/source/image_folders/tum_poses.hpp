// SPDX-License-Identifier: BSD-3-Clause
// True poses with their own times, in the format of the TUM benchmarks: a line is
// "seconds tx ty tz qx qy qz qw" (s, m).
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "inspection.hpp"

namespace tolman::image_folders {

/// Times, which increase, and the pose at each time and its line.
struct StampedPoses {
  std::vector<std::int64_t> stamps_ns;
  std::vector<Eigen::Isometry3d> T_world_camera;
  std::vector<int> lines;  ///< of the file, from 1
};

/// A line with an error gives an error in `inspection` and is left out.
StampedPoses readTumPoses(const std::filesystem::path& file, Inspection& inspection);

/// The pose at `stamp_ns`, interpolated between the measured ones before and after it; empty if one
/// of these is more than `apart_ns` away.
std::optional<Eigen::Isometry3d> poseAt(const StampedPoses& poses, std::int64_t stamp_ns,
                                        std::int64_t apart_ns);

}  // namespace tolman::image_folders
