// SPDX-License-Identifier: BSD-3-Clause
#include "street_points.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <span>
#include <utility>

#include "landmarks.hpp"

namespace tolman::view_sequences {

namespace {

// Chosen, not tuned. kMatchedWidth is half of KITTI's: at a quarter two thirds of the places were
// found that half the size finds (docs/report/places.md, in a prototype).
constexpr double kNearest = 3;      // m
constexpr double kFarthest = 25;    // m
constexpr float kWidest = 20;       // m to either side
constexpr double kLargestUp = 40;   // m above or below the camera
constexpr int kMatchedWidth = 640;  // px; wider images are matched at a reduced size
constexpr int kBlockSize = 11;      // px
constexpr int kKept = 24;           // of this number of matched pixels one becomes a point

cv::Mat reduced(const Image& image, double scale) {
  const cv::Mat gray = landmarks::grayOf(image);
  if (scale == 1) return gray;
  cv::Mat small;
  cv::resize(gray, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

CentimetrePoint inCentimetres(const Eigen::Vector3d& p) {
  const auto cm = [](double m) { return static_cast<std::int16_t>(std::lround(100 * m)); };
  return {cm(p.x()), cm(p.y()), cm(p.z())};
}

}  // namespace

StereoPoints::StereoPoints(const CameraRig& rig) {
  if (!rig.isStereo() || !rig.calibrated || rig.width <= 0) return;
  // Powers of 1/2, because means over whole blocks of pixels are fast.
  while (scale_ * rig.width > kMatchedWidth) scale_ /= 2;
  const Pinhole& K = rig.pinhole;
  pinhole_ = {K.fx * scale_, K.fy * scale_, (K.cx + 0.5) * scale_ - 0.5,
              (K.cy + 0.5) * scale_ - 0.5};
  product_ = pinhole_.fx * rig.baseline;
  const double largest = std::ceil(product_ / kNearest / 16) * 16;
  can_measure_ = largest + kBlockSize < scale_ * rig.width && scale_ * rig.height > kBlockSize;
  disparities_ = can_measure_ ? static_cast<int>(largest) : 0;
}

std::vector<CentimetrePoint> StereoPoints::pointsOf(const Frame& frame) const {
  std::vector<CentimetrePoint> points;
  if (!can_measure_ || frame.left.empty() || frame.right.empty()) return points;
  const cv::Ptr<cv::StereoBM> matcher = cv::StereoBM::create(disparities_, kBlockSize);
  // Chosen, not tuned; OpenCV's units: sum of gradients in a block, and per cent.
  matcher->setTextureThreshold(10);
  matcher->setUniquenessRatio(10);
  cv::Mat disparity;  // px * 16
  matcher->compute(reduced(frame.left, scale_), reduced(frame.right, scale_), disparity);
  const auto least = static_cast<std::int16_t>(16 * product_ / kFarthest);
  int matched = 0;
  for (int v = 0; v < disparity.rows; ++v) {
    const auto* row = disparity.ptr<std::int16_t>(v);
    for (int u = 0; u < disparity.cols; ++u) {
      if (row[u] <= least || matched++ % kKept != 0) continue;
      const Eigen::Vector3d p = pinhole_.ray({u, v}) * (16 * product_ / row[u]);
      const bool keeps =
          p.z() > kNearest && std::abs(p.x()) < kWidest && std::abs(p.y()) < kLargestUp;
      if (keeps) points.push_back(inCentimetres(p));
    }
  }
  return points;
}

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
