// SPDX-License-Identifier: BSD-3-Clause
// Halved images, mirrored around their borders.
#include "flow_pyramid.hpp"

#include <algorithm>
#include <cstring>
#include <opencv2/imgproc.hpp>

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

}  // namespace tolman::feature_stereo
