// SPDX-License-Identifier: BSD-3-Clause
#include "pose_agreement.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::view_sequences {
namespace {

// Chosen, not tuned.
constexpr double kMinApart = 4;              // m of path: a chance match does not last so long
constexpr double kMaxApart = 12;             // m of path
constexpr double kLargestGap = 1.5;          // m, between the poses
constexpr double kLargestTurn = 0.12;        // rad
constexpr std::uint64_t kMaxMeasured = 200;  // a larger number is damage

void putPlanar(StateWriter& writer, const PlanarPose& pose) {
  for (const double value : {pose.x, pose.y, pose.theta}) writer.put(value);
}

bool getPlanar(StateReader& reader, PlanarPose& pose) {
  for (double* value : {&pose.x, &pose.y, &pose.theta}) *value = reader.get<double>();
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta);
}

}  // namespace

bool PoseAgreement::add(double path, const PlanarPose& stored, const PlanarPose& driven) {
  while (!measured_.empty() && measured_.front().path < path - kMaxApart) measured_.pop_front();
  const bool agrees = std::ranges::any_of(measured_, [&](const Measured& earlier) {
    if (path - earlier.path < kMinApart) return false;
    const PlanarPose expected = compose(earlier.stored, between(earlier.driven, driven));
    const PlanarPose gap = between(expected, stored);
    return std::hypot(gap.x, gap.y) < kLargestGap && std::abs(gap.theta) < kLargestTurn;
  });
  measured_.push_back({path, stored, driven});
  return agrees;
}

void PoseAgreement::save(StateWriter& writer) const {
  writer.put(static_cast<std::uint64_t>(measured_.size()));
  for (const Measured& one : measured_) {
    writer.put(one.path);
    putPlanar(writer, one.stored);
    putPlanar(writer, one.driven);
  }
}

bool PoseAgreement::load(StateReader& reader) {
  measured_.clear();
  const auto count = reader.get<std::uint64_t>();
  if (count > kMaxMeasured) return false;
  for (std::uint64_t i = 0; i < count; ++i) {
    Measured one;
    one.path = reader.get<double>();
    const bool sound = getPlanar(reader, one.stored) && getPlanar(reader, one.driven);
    if (!sound || !std::isfinite(one.path)) return false;
    measured_.push_back(one);
  }
  return true;
}

}  // namespace tolman::view_sequences
