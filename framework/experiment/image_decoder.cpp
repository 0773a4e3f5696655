// SPDX-License-Identifier: BSD-3-Clause
// Decodes one image file by plain cv::imread. A library of its own, opened only by `tolman bench
// odometry`: OpenCV's codecs bring some 140 libraries, which would slow down the start of every
// command and of every isolated stage.
#include <opencv2/imgcodecs.hpp>

#include "tolman/image_cv.hpp"

/// False when the file cannot be decoded. The orientation in EXIF data is ignored, as by the
/// sources.
extern "C" __attribute__((visibility("default"))) bool tolman_decode_image(const char* file,
                                                                           bool colour,
                                                                           tolman::Image& image) {
  const int mode = colour ? cv::IMREAD_COLOR : cv::IMREAD_GRAYSCALE;
  const cv::Mat pixels = cv::imread(file, mode | cv::IMREAD_IGNORE_ORIENTATION);
  image = tolman::asImage(pixels);
  return !image.empty();
}
