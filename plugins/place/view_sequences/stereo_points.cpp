// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_points.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

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

}  // namespace tolman::view_sequences
