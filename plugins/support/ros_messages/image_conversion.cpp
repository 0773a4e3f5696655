// SPDX-License-Identifier: BSD-3-Clause
#include "image_conversion.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <new>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "coded_image.hpp"
#include "depth_array.hpp"
#include "png_decoder.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::ros_messages {
namespace {

constexpr int kCopy = -1;  // no conversion of colours

/// How pixels of an encoding are stored, and which conversions of OpenCV make them grey and BGR.
struct PixelLayout {
  std::string_view name;
  int channels;
  int bytes;  ///< of one channel; 0: 8 or 16 bits by the end of the name
  int to_gray;
  int to_bgr;
  bool has_chroma_rows = false;  ///< half as many rows again, of colour

  /// Rows of bytes of an image of this height.
  int rows(int height) const { return has_chroma_rows ? height + height / 2 : height; }
};

// OpenCV names Bayer patterns by the second row, columns two and three.
constexpr std::array kEncodings = {
    PixelLayout{"mono8", 1, 1, kCopy, cv::COLOR_GRAY2BGR},
    PixelLayout{"8uc1", 1, 1, kCopy, cv::COLOR_GRAY2BGR},
    PixelLayout{"mono16", 1, 2, kCopy, cv::COLOR_GRAY2BGR},
    PixelLayout{"bgr8", 3, 1, cv::COLOR_BGR2GRAY, kCopy},
    PixelLayout{"8uc3", 3, 1, cv::COLOR_BGR2GRAY, kCopy},
    PixelLayout{"rgb8", 3, 1, cv::COLOR_RGB2GRAY, cv::COLOR_RGB2BGR},
    PixelLayout{"bgra8", 4, 1, cv::COLOR_BGRA2GRAY, cv::COLOR_BGRA2BGR},
    PixelLayout{"rgba8", 4, 1, cv::COLOR_RGBA2GRAY, cv::COLOR_RGBA2BGR},
    PixelLayout{"8uc4", 4, 1, cv::COLOR_BGRA2GRAY, cv::COLOR_BGRA2BGR},
    PixelLayout{"bayer_rggb", 1, 0, cv::COLOR_BayerBG2GRAY, cv::COLOR_BayerBG2BGR},
    PixelLayout{"bayer_bggr", 1, 0, cv::COLOR_BayerRG2GRAY, cv::COLOR_BayerRG2BGR},
    PixelLayout{"bayer_gbrg", 1, 0, cv::COLOR_BayerGR2GRAY, cv::COLOR_BayerGR2BGR},
    PixelLayout{"bayer_grbg", 1, 0, cv::COLOR_BayerGB2GRAY, cv::COLOR_BayerGB2BGR},
    PixelLayout{"yuv422", 2, 1, cv::COLOR_YUV2GRAY_UYVY, cv::COLOR_YUV2BGR_UYVY},
    PixelLayout{"uyvy", 2, 1, cv::COLOR_YUV2GRAY_UYVY, cv::COLOR_YUV2BGR_UYVY},
    PixelLayout{"yuv422_yuy2", 2, 1, cv::COLOR_YUV2GRAY_YUY2, cv::COLOR_YUV2BGR_YUY2},
    PixelLayout{"yuy2", 2, 1, cv::COLOR_YUV2GRAY_YUY2, cv::COLOR_YUV2BGR_YUY2},
    PixelLayout{"yuyv", 2, 1, cv::COLOR_YUV2GRAY_YUY2, cv::COLOR_YUV2BGR_YUY2},
    PixelLayout{"nv12", 1, 1, cv::COLOR_YUV2GRAY_420, cv::COLOR_YUV2BGR_NV12, true},
    PixelLayout{"nv21", 1, 1, cv::COLOR_YUV2GRAY_420, cv::COLOR_YUV2BGR_NV21, true}};

/// By its name in any case, as V4L2 and ROS write it.
std::optional<PixelLayout> layoutOf(std::string_view encoding) {
  std::string name(encoding.substr(0, 40));
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  const int bayer_bytes = name.ends_with("16") ? 2 : 1;
  if (name.starts_with("bayer_")) name.resize(std::string_view("bayer_rggb").size());
  const auto found = std::ranges::find(kEncodings, name, &PixelLayout::name);
  if (found == kEncodings.end()) return std::nullopt;
  PixelLayout layout = *found;
  if (layout.bytes == 0) layout.bytes = bayer_bytes;
  return layout;
}

Status damaged(const Message& message) {
  return Status::invalidInput(message.bytes.empty() ? "is empty" : "is no complete message");
}

/// Fails unless the message contains all rows, of `pixel_bytes` bytes per pixel.
Status checkRows(const ImageMessage& image, ImageSize size, int pixel_bytes) {
  const std::uint64_t row =
      static_cast<std::uint64_t>(size.width) * static_cast<unsigned>(pixel_bytes);
  const std::uint64_t rows = static_cast<std::uint64_t>(size.height);
  if (image.step < row) {
    return Status::invalidInput("has rows of " + std::to_string(image.step) + " bytes instead of " +
                                std::to_string(row));
  }
  const std::uint64_t bytes = image.data.size();
  const bool fits = bytes >= image.step * (rows - 1) + row && bytes <= image.step * rows;
  if (fits) return Status::ok();
  return Status::invalidInput("has " + std::to_string(bytes) + " bytes of pixels instead of " +
                              std::to_string(image.step * rows));
}

Result<ImageSize> plausibleSize(std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kMaxPixels = 100'000'000;  // bounds memory: 300 MB of colour
  if (width < 1 || height < 1 || width > kMaxPixels || height > kMaxPixels / width) {
    return Status::invalidInput("claims an impossible size of " + std::to_string(width) + "x" +
                                std::to_string(height) + " px");
  }
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

cv::Mat eightOfSixteen(const ImageMessage& image, ImageSize size, UsedBits& bits) {
  cv::Mat pixels(size.height, size.width, CV_8UC1);
  const std::size_t upper = image.big_endian ? 0 : 1;
  for (int y = 0; y < size.height; ++y) {
    const std::uint8_t* from =
        image.data.data() + std::size_t{image.step} * static_cast<unsigned>(y);
    std::uint8_t* to = pixels.ptr(y);
    for (int x = 0; x < size.width; ++x, from += 2) {
      to[x] = bits.convert(static_cast<std::uint16_t>(from[upper] << 8 | from[1 - upper]));
    }
  }
  return pixels;
}

Result<Image> convertRaw(ImageMessage image, bool colour, UsedBits& bits) {
  const std::optional<PixelLayout> encoding = layoutOf(image.encoding);
  if (!encoding) {
    return Status::unsupported("has the encoding '" + std::string(image.encoding.substr(0, 40)) +
                               "', which cannot be converted");
  }
  Result<ImageSize> size = plausibleSize(image.width, image.height);
  if (!size.isOk()) return size.status();
  const bool odd = size.value().width % 2 != 0 || size.value().height < 2 ||
                   size.value().width < 4 ||
                   (encoding->has_chroma_rows && size.value().height % 2 != 0);
  size.value().height = encoding->rows(size.value().height);
  const bool is_packed = image.data.size() == static_cast<std::size_t>(size.value().width) *
                                                  static_cast<std::size_t>(size.value().height);
  // Drivers give the bytes of all planes by row, or of one.
  if (encoding->has_chroma_rows && is_packed) image.step = image.width;
  const Status status = checkRows(image, size.value(), encoding->channels * encoding->bytes);
  if (!status.isOk()) return status;
  cv::Mat pixels =
      encoding->bytes == 2
          ? eightOfSixteen(image, size.value(), bits)
          : cv::Mat(size.value().height, size.value().width, CV_8UC(encoding->channels),
                    const_cast<std::uint8_t*>(image.data.data()), image.step);
  const int conversion = colour ? encoding->to_bgr : encoding->to_gray;
  if (conversion == kCopy) return asImage(pixels.clone());
  const bool is_subsampled = encoding->channels == 2 || encoding->has_chroma_rows;
  if (odd && (is_subsampled || encoding->name.starts_with("bayer"))) {
    return Status::unsupported("has a size that its encoding cannot have");
  }
  cv::Mat converted;
  try {
    cv::cvtColor(pixels, converted, conversion);
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
    return Status::unsupported("has a size that its encoding cannot have");
  }
  return asImage(converted);
}

/// The format of a CompressedImage of depth: "16UC1; png compressed", "32FC1; compressedDepth png".
bool isDepthFormat(std::string_view format) {
  return format.starts_with("16UC1") || format.starts_with("32FC1") ||
         format.find("compressedDepth") != std::string_view::npos;
}

/// compressedDepth of image_transport has a header of 12 bytes (format, and two parameters a, b of
/// quantised inverse depth) before its PNG: a depth of 32FC1 is a / (value - b) m, one of 16UC1 is
/// in mm.
Result<std::vector<float>> codedDepth(const CompressedImageMessage& image, ImageSize& size) {
  constexpr std::size_t kHeader = 12;
  const bool has_header = image.format.find("compressedDepth") != std::string_view::npos;
  if (has_header && image.data.size() < kHeader) return Status::invalidInput("is not complete");
  const auto png = coded_images::decodeDepth(has_header ? image.data.subspan(kHeader) : image.data);
  if (!png.isOk()) return png.status();
  ByteReader header(image.data);
  header.number<std::uint32_t>();
  const auto a = std::bit_cast<float>(header.number<std::uint32_t>());
  const auto b = std::bit_cast<float>(header.number<std::uint32_t>());
  const bool quantised = has_header && image.format.starts_with("32FC1");
  size = {png.value().width, png.value().height};
  std::vector<float> depth;
  depth.reserve(png.value().values.size());
  for (const std::uint16_t value : png.value().values) {
    const auto number = static_cast<float>(value);
    const float metres = value == 0 ? 0 : quantised ? a / (number - b) : number / 1000.0F;
    depth.push_back(metres > 0 && metres < 1e6F ? metres : 0);
  }
  return depth;
}

}  // namespace

std::string doubtOfRows(const Message& message) {
  const auto image = readImage(message);
  const auto layout = image ? layoutOf(image->encoding) : std::nullopt;
  if (!layout) return "";
  const std::uint64_t row =
      std::uint64_t{image->width} * static_cast<unsigned>(layout->channels * layout->bytes);
  if (row == 0 || image->step < 2 * row || image->step % row != 0) return "";
  return "has rows of " + std::to_string(image->step) + " bytes, " +
         std::to_string(image->step / row) + " times those of " + std::to_string(image->width) +
         " px in the encoding '" + std::string(image->encoding) +
         "': are the encoding and the width right?";
}

Result<ImageSize> imageSize(const std::string& type, const Message& message) {
  if (type == kCompressedImage) {
    const auto image = readCompressedImage(message);
    if (!image) return damaged(message);
    UsedBits bits;
    const Result<Image> decoded = coded_images::decodeImage(image->data, false, bits);
    if (!decoded.isOk()) return decoded.status();
    return ImageSize{decoded.value().width(), decoded.value().height()};
  }
  const auto image = readImage(message);
  return image ? plausibleSize(image->width, image->height) : damaged(message);
}

Result<Image> convertImage(const std::string& type, const Message& message, bool colour,
                           UsedBits& bits) {
  if (type == kCompressedImage) {
    const auto image = readCompressedImage(message);
    return image ? coded_images::decodeImage(image->data, colour, bits) : damaged(message);
  }
  const auto image = readImage(message);
  return image ? convertRaw(*image, colour, bits) : damaged(message);
}

Result<Image> convertImage(const std::string& type, const Message& message, bool colour) {
  UsedBits bits;
  return convertImage(type, message, colour, bits);
}

Result<Image> convertImage(const std::string& type, const Message& message, bool colour,
                           ImageSize size, const std::string& first, UsedBits& bits) {
  Result<Image> image = convertImage(type, message, colour, bits);
  if (!image.isOk()) return image;
  const ImageSize found{image.value().width(), image.value().height()};
  if (found == size) return image;
  return Status::invalidInput("has " + found.text() + ", and the first of " + first + " has " +
                              size.text());
}

bool isDepth(const std::string& type, const Message& message) {
  if (type == kCompressedImage) {
    const auto image = readCompressedImage(message);
    return image && isDepthFormat(image->format);
  }
  const auto image = readImage(message);
  return image && (image->encoding == "16UC1" || image->encoding == "32FC1");
}

Result<std::vector<float>> convertDepth(const std::string& type, const Message& message,
                                        ImageSize& size) {
  if (type == kCompressedImage) {
    const auto coded = readCompressedImage(message);
    return coded ? codedDepth(*coded, size) : damaged(message);
  }
  const auto image = readImage(message);
  if (!image) return damaged(message);
  const bool millimetres = image->encoding == "16UC1" || image->encoding == "mono16";
  if (!millimetres && image->encoding != "32FC1") {
    return Status::unsupported("has the encoding '" + std::string(image->encoding.substr(0, 40)) +
                               "'; depth is 16UC1 or 32FC1");
  }
  const Result<ImageSize> claimed = plausibleSize(image->width, image->height);
  if (!claimed.isOk()) return claimed.status();
  size = claimed.value();
  const int bytes = millimetres ? 2 : 4;
  if (Status status = checkRows(*image, size, bytes); !status.isOk()) return status;
  std::vector<float> depth;
  depth.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  for (int y = 0; y < size.height; ++y) {
    const std::uint8_t* at =
        image->data.data() + std::size_t{image->step} * static_cast<unsigned>(y);
    for (int x = 0; x < size.width; ++x, at += bytes) {
      std::uint32_t bits = 0;
      for (int i = 0; i < bytes; ++i) {
        bits |= std::uint32_t{at[i]}
                << static_cast<unsigned>(8 * (image->big_endian ? bytes - 1 - i : i));
      }
      const float metres =
          millimetres ? static_cast<float>(bits) / 1000.0F : std::bit_cast<float>(bits);
      depth.push_back(metres > 0 && metres < 1e6F ? metres : 0);  // nor infinite, nor NaN
    }
  }
  return depth;
}

ArrayInfo depthInfo() {
  return source_parameters::depthArray("depth",
                                       "depth along the optical axis, 0 where it is not known");
}

}  // namespace tolman::ros_messages
