// SPDX-License-Identifier: BSD-3-Clause
#include "street_points.hpp"

#include <cmath>
#include <span>
#include <utility>

namespace tolman::view_sequences {
namespace {

constexpr double kStreetReach = 30;        // m of path; chosen on district (docs/report/places.md)
constexpr double kMinReach = 15;           // m; grids over less differ too much; chosen, not tuned
constexpr double kPatchSpacing = 0.99;     // m between patches: once in a step of 1 m
constexpr std::int64_t kMinPoints = 500;   // in a grid; a street has 10^4; chosen, not tuned
constexpr std::uint64_t kMaxPatches = 64;  // a larger number is damage

void putPose(StateWriter& writer, const Eigen::Isometry3d& T) {
  writer.putAll<double>(std::span(T.matrix().data(), 16));
}

bool getPose(StateReader& reader, Eigen::Isometry3d& T) {
  reader.getAll<double>(std::span(T.matrix().data(), 16));
  return T.matrix().allFinite();
}

}  // namespace

void StreetPoints::move(const Eigen::Isometry3d& T_previous_current) {
  T_start_camera_ = normalised(T_start_camera_ * T_previous_current);
}

bool StreetPoints::wantsPoints(double path) const {
  return patches_.empty() || path - patches_.back().path >= kPatchSpacing;
}

void StreetPoints::add(std::vector<CentimetrePoint> points, double path) {
  patches_.push_back({path, T_start_camera_, std::move(points)});
  while (patches_.front().path < path - kStreetReach) patches_.pop_front();
}

void StreetPoints::restart() {
  patches_.clear();
  T_start_camera_.setIdentity();
}

std::optional<StructureLevels> StreetPoints::levels(double yaw) const {
  if (patches_.empty() || patches_.back().path - patches_.front().path < kMinReach) return {};
  StructureCounts counts;
  const Eigen::Matrix3d turn = expSo3({0, -yaw, 0});
  for (const Patch& patch : patches_) {
    const Eigen::Isometry3d T = T_start_camera_.inverse() * patch.T_start_camera;
    const Eigen::Matrix3f R = (0.01 * turn * T.linear()).cast<float>();  // points are in cm
    const Eigen::Vector3f t = (turn * T.translation()).cast<float>();
    for (const CentimetrePoint& point : patch.points) counts.add(R * point.cast<float>() + t);
  }
  if (counts.points() < kMinPoints) return {};
  return counts.levels();
}

void StreetPoints::save(StateWriter& writer) const {
  putPose(writer, T_start_camera_);
  writer.put(static_cast<std::uint64_t>(patches_.size()));
  for (const Patch& patch : patches_) {
    writer.put(patch.path);
    putPose(writer, patch.T_start_camera);
    writer.put(static_cast<std::uint64_t>(patch.points.size()));
    for (const CentimetrePoint& point : patch.points) {
      writer.putAll<std::int16_t>(std::span(point.data(), 3));
    }
  }
}

bool StreetPoints::load(StateReader& reader) {
  restart();
  if (!getPose(reader, T_start_camera_)) return false;
  const auto patches = reader.get<std::uint64_t>();
  if (patches > kMaxPatches) return false;
  for (std::uint64_t i = 0; i < patches; ++i) {
    Patch patch;
    patch.path = reader.get<double>();
    const bool follows = patches_.empty() || patch.path > patches_.back().path;
    if (!getPose(reader, patch.T_start_camera) || !std::isfinite(patch.path) || !follows)
      return false;
    const auto points = reader.get<std::uint64_t>();
    if (points > reader.remaining() / (3 * sizeof(std::int16_t))) return false;
    patch.points.resize(points);
    for (CentimetrePoint& point : patch.points)
      reader.getAll<std::int16_t>(std::span(point.data(), 3));
    patches_.push_back(std::move(patch));
  }
  return true;
}

}  // namespace tolman::view_sequences
