// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/kitti_segments.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

constexpr std::size_t kStartEvery = 10;
constexpr double kLongestOvershoot = 0.1;  // of a segment's length

/// The length that the errors of a segment are divided by. It is the nominal length, as in KITTI's
/// program, if the segment ends at the first true pose beyond it; the true length, if true poses
/// before that end have no estimate. None if that makes the segment too long, if it ends in another
/// piece of the path, or if its true length is more than twice the nominal one, because frames are
/// far apart.
std::optional<double> lengthOf(const Matches& matches, std::size_t from, std::size_t to,
                               double nominal) {
  if (!matches.inOnePiece(from, to)) return std::nullopt;
  const double driven = matches.driven[to] - matches.driven[from];
  if (driven > 2 * nominal) return std::nullopt;
  if (matches.index[to] == matches.index[to - 1] + 1) return nominal;
  if (driven > (1 + kLongestOvershoot) * nominal) return std::nullopt;
  return driven;
}

}  // namespace

SegmentLengths kittiLengths() { return {"kitti", {100, 200, 300, 400, 500, 600, 700, 800}}; }

SegmentLengths shortLengths() { return {"short", {5, 10, 20, 30, 40, 50}}; }

SegmentLengths lengthsFor(double truth_path_length_m) {
  return truth_path_length_m >= 200 ? kittiLengths() : shortLengths();
}

SegmentErrors segmentErrors(const Matches& matches, const SegmentLengths& lengths) {
  SegmentErrors result;
  result.lengths = lengths;
  double translation = 0;  // sum of errors, m per m
  double rotation = 0;     // rad/m
  const std::vector<double>& distance = matches.driven;
  for (std::size_t from = 0; from < matches.size(); from += kStartEvery) {
    for (const double nominal : lengths.lengths_m) {
      const auto end = std::upper_bound(distance.begin(), distance.end(), distance[from] + nominal);
      if (end == distance.end()) continue;
      const auto to = static_cast<std::size_t>(end - distance.begin());
      const auto length = lengthOf(matches, from, to, nominal);
      if (!length) {
        ++result.segments_in_gaps;
        continue;
      }
      const Eigen::Isometry3d truth =
          matches.truth[from].T_world_camera.inverse() * matches.truth[to].T_world_camera;
      const Eigen::Isometry3d estimate =
          matches.estimate[from].T_world_camera.inverse() * matches.estimate[to].T_world_camera;
      const Eigen::Isometry3d error = estimate.inverse() * truth;
      translation += error.translation().norm() / *length;
      rotation += logSo3(error.linear()).norm() / *length;
      ++result.segments;
    }
  }
  if (result.segments == 0) return result;
  const auto count = static_cast<double>(result.segments);
  result.t_rel_percent = 100 * translation / count;
  result.r_rel_deg_per_100m = 100 * rotation / count * 180 / std::numbers::pi;
  return result;
}

}  // namespace tolman::evaluation
