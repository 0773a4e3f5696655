// SPDX-License-Identifier: BSD-3-Clause
// True poses with times of their own.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tolman::source_parameters {

/// The stamps increase.
struct StampedPoses {
  std::vector<std::int64_t> stamps_ns;
  std::vector<Eigen::Isometry3d> T_world_camera;
};

/// The pose at `stamp_ns`, interpolated between the measured ones before and after it; empty if one
/// of these is more than `apart_ns` away, or both are more than `gap_ns` from each other.
inline std::optional<Eigen::Isometry3d> poseAt(
    const StampedPoses& poses, std::int64_t stamp_ns, std::int64_t apart_ns,
    std::int64_t gap_ns = std::numeric_limits<std::int64_t>::max()) {
  const auto& stamps = poses.stamps_ns;
  const auto after = std::lower_bound(stamps.begin(), stamps.end(), stamp_ns);
  if (after == stamps.end() || *after - stamp_ns > apart_ns) return std::nullopt;
  const auto i = static_cast<std::size_t>(after - stamps.begin());
  if (*after == stamp_ns) return poses.T_world_camera[i];
  if (i == 0 || stamp_ns - after[-1] > apart_ns || *after - after[-1] > gap_ns) return std::nullopt;
  const Eigen::Isometry3d& a = poses.T_world_camera[i - 1];
  const Eigen::Isometry3d& b = poses.T_world_camera[i];
  const double share =
      static_cast<double>(stamp_ns - after[-1]) / static_cast<double>(*after - after[-1]);
  const Eigen::Quaterniond q =
      Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
  return Eigen::Isometry3d(
      Eigen::Translation3d((1 - share) * a.translation() + share * b.translation()) * q);
}

}  // namespace tolman::source_parameters
