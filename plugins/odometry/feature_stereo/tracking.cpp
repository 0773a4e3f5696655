// SPDX-License-Identifier: BSD-3-Clause
// Halved images, mirrored around their borders.
#include "tracking.hpp"

#include <algorithm>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "patch_alignment.hpp"

namespace tolman::feature_stereo {

namespace {

/// Index in [0, size) of a pixel outside, mirrored at the outermost pixel.
int mirrored(int index, int size) {
  if (size == 1) return 0;
  const int period = 2 * (size - 1);
  const int rest = ((index % period) + period) % period;
  return std::min(rest, period - rest);
}

void fillMargin(cv::Mat& memory, cv::Size margin) {
  const int width = memory.cols - 2 * margin.width;
  const int height = memory.rows - 2 * margin.height;
  for (int y = 0; y < height; ++y) {
    uchar* row = memory.ptr<uchar>(y + margin.height) + margin.width;
    for (int x = 1; x <= margin.width; ++x) {
      row[-x] = row[mirrored(-x, width)];
      row[width - 1 + x] = row[mirrored(width - 1 + x, width)];
    }
  }
  const auto bytes = static_cast<std::size_t>(memory.cols);
  for (int y = 1; y <= margin.height; ++y) {
    const int below = height - 1 + y;
    std::memcpy(memory.ptr(margin.height - y), memory.ptr(margin.height + mirrored(-y, height)),
                bytes);
    std::memcpy(memory.ptr(margin.height + below),
                memory.ptr(margin.height + mirrored(below, height)), bytes);
  }
}

}  // namespace

void FlowPyramid::build(const cv::Mat& gray, int window, int levels) {
  // A patch whose centre is a pixel outside, with one more pixel around for its derivatives.
  const cv::Size margin(toLanes(window + 2) + 4, window / 2 + 6);
  cv::Size size = gray.size();
  std::size_t count = 0;
  memory_.resize(static_cast<std::size_t>(levels));
  images_.resize(static_cast<std::size_t>(levels));
  for (; count < images_.size() && (count == 0 || std::min(size.width, size.height) > window);
       ++count) {
    cv::Mat& memory = memory_[count];
    memory.create(size + margin + margin, CV_8UC1);
    images_[count] = memory(cv::Rect(cv::Point(margin.width, margin.height), size));
    if (count == 0) {
      gray.copyTo(images_[0]);
    } else {
      cv::pyrDown(images_[count - 1], images_[count], size);
    }
    fillMargin(memory, margin);
    size = {(size.width + 1) / 2, (size.height + 1) / 2};
  }
  memory_.resize(count);
  images_.resize(count);
}

PaddedImage FlowPyramid::padded(int index) const {
  const cv::Mat& image = level(index);
  return {image.data, static_cast<std::ptrdiff_t>(image.step[0]), image.cols, image.rows};
}

// Lucas-Kanade from coarse to fine, and back on the finest level.

namespace {

// px, of the last step; chosen, not tuned.
constexpr float kTolerance = 0.01F;
constexpr float kCoarseTolerance = 0.05F;

bool insideImage(const cv::Point2f& point, const cv::Size& size) {
  // px of the centre from the border; the patch may exceed it. Chosen, not tuned.
  constexpr float kMargin = 3;
  return point.x >= kMargin && point.y >= kMargin &&
         point.x < static_cast<float>(size.width) - kMargin &&
         point.y < static_cast<float>(size.height) - kMargin;
}

/// Moves `to` level by level. Where a coarse level has no texture, the next one starts from the
/// same place.
bool follow(const FlowPyramid& from_image, const FlowPyramid& to_image, const cv::Point2f& from,
            cv::Point2f& to, int levels, Patch& patch) {
  for (int level = levels - 1; level >= 0; --level) {
    const float scale = 1.0F / static_cast<float>(1 << level);
    cv::Point2f place = scale * to;
    const bool found =
        patch.take(from_image.padded(level), scale * from) &&
        patch.align(to_image.padded(level), place, level == 0 ? kTolerance : kCoarseTolerance);
    if (found) to = place / scale;
    if (!found && level == 0) return false;
  }
  return true;
}

}  // namespace

std::vector<bool> trackCorners(const FlowPyramid& from_image, const FlowPyramid& to_image,
                               const std::vector<cv::Point2f>& from, std::vector<cv::Point2f>& to,
                               const TrackSettings& settings) {
  std::vector<bool> good(from.size(), false);
  if (from.empty()) return good;
  const int levels = std::min({settings.levels, from_image.levels(), to_image.levels()});
  Patch patch(settings.window);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!follow(from_image, to_image, from[i], to[i], levels, patch)) continue;
    if (!insideImage(to[i], to_image.size())) continue;
    // A track that went astray seldom comes back to where it started, even if it starts there. From
    // coarse to fine the check would find a few more, at a tenth more time and without a gain.
    cv::Point2f back = from[i];
    if (!follow(to_image, from_image, to[i], back, 1, patch)) continue;
    good[i] = cv::norm(back - from[i]) <= settings.consistency;
  }
  return good;
}

}  // namespace tolman::feature_stereo
