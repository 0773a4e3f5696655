// SPDX-License-Identifier: BSD-3-Clause
#include "coded_image.hpp"

#include <new>
#include <opencv2/imgcodecs.hpp>

#include "jpeg_decoder.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::ros_messages {
namespace {

using namespace std::string_view_literals;

std::uint32_t bigEndian(Bytes bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : bytes.subspan(at, count)) value = value << 8U | byte;
  return value;
}

Result<ImageSize> pngSize(Bytes coded) {
  constexpr std::size_t kHeaderEnd = 33;  // bytes; signature and IHDR of PNG
  if (coded.size() < kHeaderEnd || asText(coded).substr(12, 4) != "IHDR") {
    return Status::invalidInput("is a PNG image with a damaged header");
  }
  if (asText(coded).rfind("IEND") == std::string_view::npos) {
    return Status::invalidInput("is a PNG image without its end");
  }
  return plausibleSize(bigEndian(coded, 16, 4), bigEndian(coded, 20, 4));
}

/// Reads the segments of a JPEG file up to the frame header, which contains the size.
Result<ImageSize> jpegSize(Bytes coded) {
  if (asText(coded).rfind("\xff\xd9"sv) == std::string_view::npos) {
    return Status::invalidInput("is a JPEG image without its end");
  }
  std::size_t at = 2;
  while (at + 9 <= coded.size() && coded[at] == 0xff) {
    const std::uint8_t marker = coded[at + 1];
    const bool table = marker == 0xc4 || marker == 0xc8 || marker == 0xcc;
    if (marker >= 0xc0 && marker <= 0xcf && !table) {
      return plausibleSize(bigEndian(coded, at + 7, 2), bigEndian(coded, at + 5, 2));
    }
    at += marker == 0xff ? 1 : 2 + std::size_t{bigEndian(coded, at + 2, 2)};
  }
  return Status::invalidInput("is a JPEG image with a damaged header");
}

bool isJpeg(Bytes coded) { return asText(coded).starts_with("\xff\xd8"sv); }

cv::Mat eightBits(const cv::Mat& pixels, DeepPixels& deep) {
  cv::Mat converted(pixels.rows, pixels.cols, CV_MAKETYPE(CV_8U, pixels.channels()));
  for (int y = 0; y < pixels.rows; ++y) {
    const auto* from = pixels.ptr<std::uint16_t>(y);
    std::transform(from, from + pixels.cols * pixels.channels(), converted.ptr(y),
                   [&](std::uint16_t value) { return deep.convert(value); });
  }
  return converted;
}

Result<Image> decodePng(Bytes coded, bool colour, DeepPixels& deep) {
  const cv::Mat bytes(1, static_cast<int>(coded.size()), CV_8UC1,
                      const_cast<std::uint8_t*>(coded.data()));
  const int mode = (colour ? cv::IMREAD_COLOR : cv::IMREAD_GRAYSCALE) | cv::IMREAD_ANYDEPTH |
                   cv::IMREAD_IGNORE_ORIENTATION;
  try {
    const cv::Mat pixels = cv::imdecode(bytes, mode);
    if (!pixels.empty())
      return asImage(pixels.depth() == CV_16U ? eightBits(pixels, deep) : pixels);
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
  }
  return Status::invalidInput("cannot be decoded");
}

}  // namespace

Result<ImageSize> plausibleSize(std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kMaxPixels = 100'000'000;  // bounds memory: 300 MB of colour
  if (width < 1 || height < 1 || width > kMaxPixels || height > kMaxPixels / width) {
    return Status::invalidInput("claims an impossible size of " + std::to_string(width) + "x" +
                                std::to_string(height) + " px");
  }
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

Result<ImageSize> codedSize(Bytes coded) {
  if (asText(coded).starts_with("\x89PNG\r\n\x1a\n"sv)) return pngSize(coded);
  if (isJpeg(coded)) return jpegSize(coded);
  return Status::invalidInput("is neither a JPEG nor a PNG image");
}

Result<Image> decodeImage(Bytes coded, bool colour, DeepPixels& deep) {
  const Result<ImageSize> size = codedSize(coded);
  if (!size.isOk()) return size.status();
  Result<Image> image =
      isJpeg(coded) ? jpeg_images::decodeJpeg(coded, colour) : decodePng(coded, colour, deep);
  if (!image.isOk() || ImageSize{image.value().width(), image.value().height()} == size.value()) {
    return image;
  }
  return Status::invalidInput("has a damaged header");
}

}  // namespace tolman::ros_messages
