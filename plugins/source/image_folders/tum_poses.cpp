// SPDX-License-Identifier: BSD-3-Clause
#include "tum_poses.hpp"

#include <algorithm>
#include <array>

#include "text_file.hpp"

namespace tolman::image_folders {
namespace {

/// The seven numbers after the time.
std::optional<Eigen::Isometry3d> parsePose(const std::vector<std::string_view>& fields) {
  constexpr double kFarthest = 1e9;  // m; the bound of trajectories that are evaluated
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto number = parseNumber(fields[i + 1]);
    if (!number) return std::nullopt;
    v[i] = *number;
  }
  const Eigen::Vector3d t(v[0], v[1], v[2]);
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (std::abs(q.norm() - 1) > 0.01 || (t.array().abs() > kFarthest).any()) return std::nullopt;
  return Eigen::Isometry3d(Eigen::Translation3d(t) * q.normalized());
}

}  // namespace

StampedPoses readTumPoses(const std::filesystem::path& file, Inspection& inspection) {
  StampedPoses poses;
  for (const TextLine& line : readLines(file, inspection)) {
    const auto fields = splitFields(line.text);
    const bool complete = fields.size() == 8;
    const auto ns = complete ? parseSeconds(fields[0]) : std::nullopt;
    const auto pose = complete ? parsePose(fields) : std::nullopt;
    if (!ns || !pose) {
      inspection.error(file, line.number,
                       "is no pose 'seconds tx ty tz qx qy qz qw' with a quaternion of length 1; "
                       "correct it, or remove the file to run without truth");
    } else if (!poses.stamps_ns.empty() && *ns <= poses.stamps_ns.back()) {
      inspection.error(file, line.number, "is no later than the line before; sort the file");
    } else {
      poses.stamps_ns.push_back(*ns);
      poses.T_world_camera.push_back(*pose);
      poses.lines.push_back(line.number);
    }
  }
  return poses;
}

std::optional<Eigen::Isometry3d> poseAt(const StampedPoses& poses, std::int64_t stamp_ns,
                                        std::int64_t apart_ns) {
  const auto& stamps = poses.stamps_ns;
  const auto after = std::lower_bound(stamps.begin(), stamps.end(), stamp_ns);
  if (after == stamps.end() || *after - stamp_ns > apart_ns) return std::nullopt;
  const auto i = static_cast<std::size_t>(after - stamps.begin());
  if (*after == stamp_ns) return poses.T_world_camera[i];
  if (i == 0 || stamp_ns - after[-1] > apart_ns) return std::nullopt;
  const Eigen::Isometry3d& a = poses.T_world_camera[i - 1];
  const Eigen::Isometry3d& b = poses.T_world_camera[i];
  const double share =
      static_cast<double>(stamp_ns - after[-1]) / static_cast<double>(*after - after[-1]);
  const Eigen::Quaterniond q =
      Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
  return Eigen::Isometry3d(
      Eigen::Translation3d((1 - share) * a.translation() + share * b.translation()) * q);
}

}  // namespace tolman::image_folders
