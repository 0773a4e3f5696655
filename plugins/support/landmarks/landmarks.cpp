// SPDX-License-Identifier: BSD-3-Clause
#include "landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "tolman/image_cv.hpp"
#include "wide_lanes.hpp"

namespace tolman::landmarks {

namespace {

constexpr double kSigma = 1;         // px of the reduced image; chosen, not tuned
constexpr double kNearest = 2;       // m; bounds the search; chosen, not tuned
constexpr double kMinDisparity = 1;  // px; chosen, not tuned
constexpr int kHalfPatch = 5;        // px; chosen, not tuned

/// Peak of the parabola through three values at -1, 0 and 1; the middle one is the largest.
double peakOf(double before, double at, double after) {
  const double curve = before - 2 * at + after;
  return curve < 0 ? 0.5 * (before - after) / curve : 0;
}

/// Index of the largest correlation, interpolated; negative if it is low or not unique.
double uniquePeak(const std::vector<float>& value) {
  constexpr float kPoor = 0.85F;   // correlation; chosen, not tuned
  constexpr float kRival = 0.95F;  // chosen, not tuned
  const auto best = static_cast<std::size_t>(std::ranges::max_element(value) - value.begin());
  if (value[best] < kPoor || best == 0 || best + 1 == value.size()) return -1;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::size_t away = i > best ? i - best : best - i;
    if (away > 2 && value[i] > kRival * value[best]) return -1;
  }
  return static_cast<double>(best) + peakOf(value[best - 1], value[best], value[best + 1]);
}

constexpr int kPatch = 2 * kHalfPatch + 1;
constexpr int kLanes = 16;  // columns of a patch, padded: the last five have no weight

/// Inner products of a patch with the `count` patches whose first columns follow each other;
/// `width`: pixels of a row.
TOLMAN_WIDE_LANES void products(const std::int16_t (*weights)[kLanes], const std::int16_t* pixels,
                                int width, int count, std::int32_t* out) {
  for (int x = 0; x < count; ++x) {
    std::int32_t product = 0;
    for (int y = 0; y < kPatch; ++y) {
      const std::int16_t* row = pixels + y * width + x;
      for (int i = 0; i < kLanes; ++i) product += weights[y][i] * row[i];
    }
    out[x] = product;
  }
}

/// Adds a row of pixels and its squares to the sums of the columns, and copies it.
TOLMAN_WIDE_LANES void addRow(const std::uint8_t* row, int count, std::int16_t* pixels,
                              std::int32_t* sums, std::int32_t* squares) {
  for (int x = 0; x < count; ++x) {
    pixels[x] = row[x];
    sums[x] += row[x];
    squares[x] += row[x] * row[x];
  }
}

/// Sums of the pixels of a patch, and of their squares.
struct Moments {
  double sum = 0;
  double squares = 0;
};

/// Normalised cross-correlations of a patch with `count` others, of which the sums are given.
TOLMAN_WIDE_LANES void correlate(Moments patch, const std::int32_t* products,
                                 const std::int32_t* sums, const std::int32_t* squares, int count,
                                 float* out) {
  constexpr double kCount = kPatch * kPatch;
  const double variance = kCount * patch.squares - patch.sum * patch.sum;
  for (int x = 0; x < count; ++x) {
    const double sum = sums[x];
    const double covariance = kCount * products[x] - patch.sum * sum;
    const double variances = variance * (kCount * squares[x] - sum * sum);
    const double root = std::sqrt(variances > 0 ? variances : 1);
    out[x] = static_cast<float>((variances > 0 ? covariance : 0) / root);
  }
}

/// Replaces each value by the sum of it and the kPatch - 1 that follow.
void sumOverPatches(std::vector<std::int32_t>& columns) {
  if (columns.size() < kPatch) return;
  std::int32_t sum = std::accumulate(columns.begin(), columns.begin() + kPatch, std::int32_t{0});
  for (std::size_t x = 0; x + kPatch < columns.size(); ++x) {
    const std::int32_t first = columns[x];
    columns[x] = sum;
    sum += columns[x + kPatch] - first;
  }
  columns[columns.size() - kPatch] = sum;
}

/// A patch of the left image, to be found in a strip of the right one.
class PatchCorrelation {
 public:
  PatchCorrelation(const cv::Mat& left, const cv::Rect& patch) {
    for (int y = 0; y < kPatch; ++y) {
      const std::uint8_t* row = left.ptr<std::uint8_t>(patch.y + y) + patch.x;
      for (int x = 0; x < kPatch; ++x) {
        weights_[y][x] = row[x];
        moments_.sum += row[x];
        moments_.squares += row[x] * row[x];
      }
    }
  }

  /// Normalised cross-correlation at each column of the strip, which has the height of the patch.
  void along(const cv::Mat& right, const cv::Rect& strip, std::vector<float>& correlations) {
    const int width = strip.width + kLanes - kPatch;
    const int count = std::max(0, strip.width - kPatch + 1);
    pixels_.assign(static_cast<std::size_t>(width * kPatch), 0);
    sums_.assign(static_cast<std::size_t>(strip.width), 0);
    squares_.assign(static_cast<std::size_t>(strip.width), 0);
    for (int y = 0; y < kPatch; ++y) {
      addRow(right.ptr<std::uint8_t>(strip.y + y) + strip.x, strip.width,
             pixels_.data() + y * width, sums_.data(), squares_.data());
    }
    sumOverPatches(sums_);
    sumOverPatches(squares_);
    products_.resize(static_cast<std::size_t>(count));
    correlations.resize(static_cast<std::size_t>(count));
    products(weights_, pixels_.data(), width, count, products_.data());
    correlate(moments_, products_.data(), sums_.data(), squares_.data(), count,
              correlations.data());
  }

 private:
  std::int16_t weights_[kPatch][kLanes] = {};
  Moments moments_;
  std::vector<std::int16_t> pixels_;
  std::vector<std::int32_t> sums_;     ///< of columns, then of patches
  std::vector<std::int32_t> squares_;  ///< as sums_
  std::vector<std::int32_t> products_;
};

}  // namespace

cv::Mat grayOf(const Image& image) {
  const cv::Mat mat = asMat(image);
  if (image.format() == PixelFormat::Gray8) return mat;
  cv::Mat gray;
  cv::cvtColor(mat, gray, cv::COLOR_BGR2GRAY);
  return gray;
}

Corners findCorners(const cv::Mat& gray, int count) {
  // Factor between levels and their number: chosen, not tuned.
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(count, 1.3F, 5);
  const int reduction = reductionOf(gray.cols);
  std::vector<cv::KeyPoint> found;
  Corners corners;
  corners.sigma = kSigma * reduction;
  orb->detectAndCompute(reducedBy(reduction, gray), cv::noArray(), found, corners.descriptions);
  for (const cv::KeyPoint& point : found) corners.pixels.push_back(wholeOf(point.pt, reduction));
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
  // Also one pixel to the right, so that a disparity of zero can be a peak, which is refused.
  const int last = std::min(left.cols, patch.x + patch.width + 1);
  const cv::Rect strip(first, patch.y, last - first, patch.height);
  std::vector<float> correlations;
  PatchCorrelation(left, patch).along(right, strip, correlations);
  const double peak = uniquePeak(correlations);
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
    if (disparity < kMinDisparity) continue;
    const Eigen::Vector3d p = K.ray({pixel.x, pixel.y}) * (K.fx * rig.baseline / disparity);
    landmarks.points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                  static_cast<float>(p.z()));
    landmarks.descriptions.push_back(corners.descriptions.row(static_cast<int>(i)));
  }
  return landmarks;
}

}  // namespace tolman::landmarks
