// SPDX-License-Identifier: BSD-3-Clause
// Trajectories as text: TUM and KITTI. The same poses give the same bytes on every machine.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <string>

#include "tolman/status.hpp"

namespace tolman::record {

struct StampedPose {
  std::int64_t frame = 0;
  std::int64_t stamp_ns = 0;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// The shortest text that reads back as exactly this double; no negative zero.
std::string numberText(double value);

/// `x y z qx qy qz qw` with qw >= 0.
std::string poseText(const Eigen::Isometry3d& T);

/// Lines `stamp tx ty tz qx qy qz qw`; the stamp has nine decimals, exactly as recorded.
std::string tumText(std::span<const StampedPose> poses);

/// Twelve numbers a line, one line a frame from frame 0. The format cannot say which frame a line
/// is: a frame without a pose repeats the pose before it (the identity before the first), so that
/// lines stay frames. InvalidInput where frames do not grow or gaps are beyond reason.
Result<std::string> kittiText(std::span<const StampedPose> poses);

}  // namespace tolman::record
