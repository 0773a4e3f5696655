// SPDX-License-Identifier: BSD-3-Clause
#include "frame_encoder.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tolman/image_cv.hpp"

namespace tolman::web_viewer {
namespace {

// Points of older frames are not sent: they no longer fit the present image.
constexpr std::int64_t kRecentFrames = 10;
// Limits of a message: about 5 MB, which the loopback interface carries ten times a second.
constexpr Eigen::Index kMaxPoints = 20'000;
constexpr std::size_t kMaxCells = 1U << 20U;  // values in all arrays
constexpr std::size_t kMaxText = 1000;        // bytes of an event's message

void addPoints(const FrameCopy& copy, std::vector<PackedArray>& arrays) {
  const bool recent = copy.points_frame >= 0 && copy.frame - copy.points_frame <= kRecentFrames;
  if (!recent || copy.points.cols() == 0) return;
  const auto count = static_cast<std::size_t>(std::min(copy.points.cols(), kMaxPoints));
  // Column-major 4 x n is row-major n x 4.
  arrays.push_back(pack<float>("points", {count, 4}, {copy.points.data(), 4 * count}));
}

void addCells(const std::vector<NamedArray>& cells, std::vector<PackedArray>& arrays) {
  std::size_t total = 0;
  for (const NamedArray& array : cells) {
    total += array.values.size();
    if (total > kMaxCells) return;
    arrays.push_back(
        pack<float>("cells." + array.name, {array.shape.begin(), array.shape.end()}, array.values));
  }
}

/// Reduces an image by an integer factor to at most `width` px: means over whole pixels take a
/// tenth of the time of other interpolations. The remainder at the right and the bottom, less than
/// a pixel of the result, is cut off.
cv::Mat shrunk(const cv::Mat& pixels, int width) {
  const int factor = std::min((pixels.cols + width - 1) / width, pixels.rows);
  if (factor <= 1) return pixels;
  const cv::Size size(pixels.cols / factor, pixels.rows / factor);
  cv::Mat small;
  cv::resize(pixels(cv::Rect(0, 0, factor * size.width, factor * size.height)), small, size, 0, 0,
             cv::INTER_AREA);
  return small;
}

}  // namespace

std::string jpeg(const Image& image, const JpegOptions& options) {
  if (image.empty()) return {};
  const cv::Mat pixels = shrunk(asMat(image), options.width);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", pixels, bytes, {cv::IMWRITE_JPEG_QUALITY, options.quality});
  return {bytes.begin(), bytes.end()};
}

EncodedFrame encodeFrame(const FrameCopy& copy, const JpegOptions& options) {
  EncodedFrame encoded;
  encoded.header.frame = copy.frame;
  encoded.header.points_frame = copy.points_frame;
  if (const std::string image = jpeg(copy.left, options); !image.empty()) {
    encoded.arrays.push_back(
        {"image", ElementType::U8, {image.size()}, std::make_shared<const std::string>(image)});
  }
  addPoints(copy, encoded.arrays);
  addCells(copy.cells, encoded.arrays);
  return encoded;
}

std::vector<RunEvent> shortened(std::vector<RunEvent> events) {
  for (RunEvent& event : events) event.message.resize(std::min(event.message.size(), kMaxText));
  return events;
}

std::string storedMessage(const EncodedFrame& frame, const std::vector<RunEvent>& events) {
  FrameHeader header = frame.header;
  header.events = shortened(events);
  return encodeContainer(headerJson(header), frame.arrays);
}

}  // namespace tolman::web_viewer
