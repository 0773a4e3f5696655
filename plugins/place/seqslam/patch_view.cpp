// SPDX-License-Identifier: BSD-3-Clause
#include "patch_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "tolman/image_cv.hpp"

namespace tolman::seqslam {
namespace {

cv::Mat1b reduced(const Image& image, const ViewSettings& settings) {
  cv::Mat small;
  cv::resize(asMat(image), small, cv::Size(settings.columns, settings.rows), 0, 0, cv::INTER_AREA);
  if (image.format() != PixelFormat::Gray8) cv::cvtColor(small, small, cv::COLOR_BGR2GRAY);
  return small;
}

std::int8_t fixedOf(double value) {
  return static_cast<std::int8_t>(std::clamp(std::lround(value * kUnit), -127L, 127L));
}

void normalisePatch(const cv::Mat1b& pixels, const cv::Rect& patch, PatchView& view) {
  std::int64_t sum = 0;
  std::int64_t squares = 0;
  for (const std::uint8_t pixel : cv::Mat1b(pixels(patch))) {
    sum += pixel;
    squares += pixel * pixel;
  }
  const std::int64_t count = patch.area();
  const std::int64_t spread = count * squares - sum * sum;  // count^2 times the variance
  if (spread == 0) return;
  const double deviations = std::sqrt(static_cast<double>(spread));
  for (int y = patch.y; y < patch.y + patch.height; ++y) {
    for (int x = patch.x; x < patch.x + patch.width; ++x) {
      const auto away = static_cast<double>(count * pixels(y, x) - sum);
      view[static_cast<std::size_t>(y * pixels.cols + x)] = fixedOf(away / deviations);
    }
  }
}

}  // namespace

PatchView patchView(const Image& image, const ViewSettings& settings) {
  const cv::Mat1b pixels = reduced(image, settings);
  const cv::Rect all(0, 0, settings.columns, settings.rows);
  PatchView view(static_cast<std::size_t>(settings.columns * settings.rows));
  for (int y = 0; y < settings.rows; y += settings.patch) {
    for (int x = 0; x < settings.columns; x += settings.patch) {
      normalisePatch(pixels, cv::Rect(x, y, settings.patch, settings.patch) & all, view);
    }
  }
  return view;
}

float differenceOf(std::span<const std::int8_t> a, std::span<const std::int8_t> b) {
  std::int32_t sum = 0;  // an integer, so that the order does not matter
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return static_cast<float>(sum) / static_cast<float>(kUnit * a.size());
}

}  // namespace tolman::seqslam
