// SPDX-License-Identifier: BSD-3-Clause
#include "landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "tolman/image_cv.hpp"

namespace tolman::landmarks {
namespace {

constexpr double kNearest = 2;  // m
constexpr double kLeastDisparity = 1;
constexpr int kHalfPatch = 5;

/// The place of the peak of a parabola through three values, the middle one the largest.
double peakOf(double before, double at, double after) {
  const double curve = before - 2 * at + after;
  return curve < 0 ? 0.5 * (before - after) / curve : 0;
}

/// The best place in a row of correlations; negative when it is poor or has a rival.
double uniquePeak(const cv::Mat& row) {
  constexpr float kPoor = 0.85F;
  constexpr float kRival = 0.95F;
  const float* const value = row.ptr<float>();
  const int best = static_cast<int>(std::max_element(value, value + row.cols) - value);
  if (value[best] < kPoor || best == 0 || best == row.cols - 1) return -1;
  for (int i = 0; i < row.cols; ++i) {
    if (std::abs(i - best) > 2 && value[i] > kRival * value[best]) return -1;
  }
  return best + peakOf(value[best - 1], value[best], value[best + 1]);
}

}  // namespace

cv::Mat grayOf(const Image& image) {
  const cv::Mat mat = asMat(image);
  if (image.format() == PixelFormat::Gray8) return mat;
  cv::Mat gray;
  cv::cvtColor(mat, gray, cv::COLOR_BGR2GRAY);
  return gray;
}

Corners findCorners(const cv::Mat& gray, int count) {
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(count, 1.3F, 5);
  std::vector<cv::KeyPoint> found;
  Corners corners;
  orb->detectAndCompute(gray, cv::noArray(), found, corners.descriptions);
  cv::KeyPoint::convert(found, corners.pixels);
  return corners;
}

double disparityAt(const cv::Mat& left, const cv::Mat& right, const cv::Point2f& pixel,
                   double largest) {
  const int x = static_cast<int>(std::lround(pixel.x));
  const int y = static_cast<int>(std::lround(pixel.y));
  const int reach = static_cast<int>(std::ceil(largest));
  const cv::Rect image(0, 0, left.cols, left.rows);
  const cv::Rect patch(x - kHalfPatch, y - kHalfPatch, 2 * kHalfPatch + 1, 2 * kHalfPatch + 1);
  if ((patch & image) != patch) return -1;
  const int first = std::max(0, patch.x - reach);
  // One pixel to the right as well, so that a disparity of zero would be a peak and is refused.
  const int last = std::min(left.cols, patch.x + patch.width + 1);
  const cv::Rect strip(first, patch.y, last - first, patch.height);
  cv::Mat correlation;
  cv::matchTemplate(right(strip), left(patch), correlation, cv::TM_CCOEFF_NORMED);
  const double peak = uniquePeak(correlation);
  return peak < 0 ? -1 : patch.x - (first + peak);
}

Landmarks findLandmarks(const cv::Mat& left, const cv::Mat& right, const CameraRig& rig,
                        const Corners& corners) {
  const Pinhole& K = rig.pinhole;
  const double largest = K.fx * rig.baseline / kNearest;
  Landmarks landmarks;
  landmarks.descriptions.create(0, kDescriptionBytes, CV_8U);
  for (std::size_t i = 0; i < corners.pixels.size(); ++i) {
    const cv::Point2f& pixel = corners.pixels[i];
    const double disparity = disparityAt(left, right, pixel, largest);
    if (disparity < kLeastDisparity) continue;
    const Eigen::Vector3d p = K.ray({pixel.x, pixel.y}) * (K.fx * rig.baseline / disparity);
    landmarks.points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                  static_cast<float>(p.z()));
    landmarks.descriptions.push_back(corners.descriptions.row(static_cast<int>(i)));
  }
  return landmarks;
}

}  // namespace tolman::landmarks
