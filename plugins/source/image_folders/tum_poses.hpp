// SPDX-License-Identifier: BSD-3-Clause
// True poses with times of their own, as the TUM benchmarks have them: a line is
// "seconds tx ty tz qx qy qz qw".
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "inspection.hpp"

namespace tolman::image_folders {

/// Lists in parallel; times increase.
struct StampedPoses {
  std::vector<std::int64_t> stamps_ns;
  std::vector<Eigen::Isometry3d> T_world_camera;
};

/// Lines with an error are errors in `inspection`, and left out.
StampedPoses readTumPoses(const std::filesystem::path& file, Inspection& inspection);

/// The pose between the two measured ones around `stamp_ns`; none where one of them is further
/// away than `apart_ns`.
std::optional<Eigen::Isometry3d> poseAt(const StampedPoses& poses, std::int64_t stamp_ns,
                                        std::int64_t apart_ns);

}  // namespace tolman::image_folders
