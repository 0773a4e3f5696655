// SPDX-License-Identifier: BSD-3-Clause
#include "png_decoder.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <new>
#include <opencv2/imgcodecs.hpp>
#include <string_view>

#include "png_filters.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::coded_images {
namespace {

using namespace std::string_view_literals;
using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kSignature = 8;    // bytes before the first chunk
constexpr std::size_t kAroundData = 12;  // bytes of a chunk: length, name and check sum

std::string_view asText(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Big-endian number of four bytes.
std::uint32_t numberAt(Bytes bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : bytes.subspan(at, 4)) value = value << 8U | byte;
  return value;
}

/// Length, name, data and CRC (section 5.3).
struct Chunk {
  Bytes bytes;  ///< the whole chunk; empty: there is no chunk

  std::string_view name() const { return asText(bytes).substr(4, 4); }
  Bytes data() const { return bytes.subspan(8, bytes.size() - kAroundData); }
  bool isIntact() const {
    const Bytes checked = bytes.subspan(4, data().size() + 4);
    return libdeflate_crc32(0, checked.data(), checked.size()) == numberAt(bytes, bytes.size() - 4);
  }
  /// Whether it does not change pixels, as comments and colour profiles do not.
  bool isExtra() const { return (bytes[4] & 0x20U) != 0 && name() != "tRNS"; }
};

/// The chunk at `at`; empty if the file ends within it.
Chunk chunkAt(Bytes png, std::size_t at) {
  if (at + kAroundData > png.size()) return {};
  const std::size_t length = numberAt(png, at);
  if (length > png.size() - at - kAroundData) return {};
  return {png.subspan(at, length + kAroundData)};
}

/// Header and data of an image that the fast way can decode.
struct PlainPng {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 0;          ///< 1 or 3
  std::vector<std::uint8_t> packed;  ///< the data of all IDAT chunks

  std::size_t rowBytes() const { return width * channels; }
  /// Bytes of all rows, each with the byte of its filter.
  std::size_t size() const { return height * (rowBytes() + 1); }
};

/// Reads size and kind; nullopt unless 8 bits, grey or RGB, not interlaced.
std::optional<PlainPng> readHeader(const Chunk& chunk) {
  constexpr std::size_t kLength = 13;
  constexpr std::uint8_t kGrey = 0;
  constexpr std::uint8_t kRgb = 2;
  const Bytes header = chunk.data();
  if (chunk.name() != "IHDR" || header.size() != kLength) return std::nullopt;
  const bool is_plain = header[8] == 8 && (header[9] == kGrey || header[9] == kRgb) &&
                        header[10] == 0 && header[11] == 0 && header[12] == 0;
  if (!is_plain) return std::nullopt;
  PlainPng image;
  image.width = numberAt(header, 0);
  image.height = numberAt(header, 4);
  image.channels = header[9] == kGrey ? 1 : 3;
  return image;
}

/// Reads header and data; nullopt for other kinds of images and for damaged ones.
std::optional<PlainPng> readChunks(Bytes png) {
  std::optional<PlainPng> image;
  std::size_t at = kSignature;
  for (Chunk chunk; !(chunk = chunkAt(png, at)).bytes.empty(); at += chunk.bytes.size()) {
    if (chunk.isExtra()) continue;
    if (!chunk.isIntact()) return std::nullopt;
    if (!image) {
      image = readHeader(chunk);
      if (!image) return std::nullopt;
      image->packed.reserve(png.size());
    } else if (chunk.name() == "IDAT") {
      image->packed.insert(image->packed.end(), chunk.data().begin(), chunk.data().end());
    } else {
      return chunk.name() == "IEND" ? image : std::nullopt;  // palette, transparency
    }
  }
  return std::nullopt;
}

/// The bytes of all rows; null if the data are damaged.
std::unique_ptr<std::uint8_t[]> inflate(const PlainPng& png) {
  constexpr std::size_t kMostPerByte = 1032;  // largest ratio of deflate; limits memory
  if (png.size() / kMostPerByte > png.packed.size()) return nullptr;
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> inflater(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!inflater) throw std::bad_alloc();
  auto rows = std::make_unique_for_overwrite<std::uint8_t[]>(png.size());
  const libdeflate_result result =
      libdeflate_zlib_decompress(inflater.get(), png.packed.data(), png.packed.size(), rows.get(),
                                 png.size(), nullptr);  // null: exactly size() bytes
  if (result != LIBDEFLATE_SUCCESS) return nullptr;
  return rows;
}

/// Decodes with OpenCV; empty if the data are damaged.
cv::Mat decodeByOpenCv(Bytes png, int mode) {
  const cv::Mat bytes(1, static_cast<int>(png.size()), CV_8UC1,
                      const_cast<std::uint8_t*>(png.data()));
  try {
    return cv::imdecode(bytes, mode | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
    return {};
  }
}

Status damaged() { return Status::invalidInput("cannot be decoded, its data are damaged"); }

}  // namespace

bool isPng(Bytes bytes) { return asText(bytes).starts_with("\x89PNG\r\n\x1a\n"sv); }

std::optional<Image> decodePlainPng(Bytes png, bool colour) {
  const std::optional<PlainPng> plain = readChunks(png);
  if (!plain || (plain->channels == 3) != colour) return std::nullopt;
  const auto rows = inflate(*plain);
  if (!rows) return std::nullopt;
  bool whole = true;
  const PixelFormat format = colour ? PixelFormat::Bgr8 : PixelFormat::Gray8;
  Image image = Image::create(static_cast<int>(plain->width), static_cast<int>(plain->height),
                              format, [&](std::uint8_t* pixels) {
                                whole = undoFilters(rows.get(), plain->height, plain->rowBytes(),
                                                    plain->channels, pixels);
                                if (colour) swapRedAndBlue(pixels, plain->width * plain->height);
                              });
  return whole ? std::optional(std::move(image)) : std::nullopt;
}

Result<Image> decodePng(Bytes png, bool colour, source_parameters::UsedBits& bits) {
  if (std::optional<Image> image = decodePlainPng(png, colour)) return *std::move(image);
  const cv::Mat pixels = decodeByOpenCv(png, colour ? cv::IMREAD_COLOR : cv::IMREAD_GRAYSCALE);
  if (pixels.empty()) return damaged();
  if (pixels.depth() != CV_16U) return asImage(pixels);
  cv::Mat narrow(pixels.rows, pixels.cols, CV_MAKETYPE(CV_8U, pixels.channels()));
  for (int y = 0; y < pixels.rows; ++y) {
    const auto* from = pixels.ptr<std::uint16_t>(y);
    std::transform(from, from + pixels.cols * pixels.channels(), narrow.ptr<std::uint8_t>(y),
                   [&](std::uint16_t value) { return bits.convert(value); });
  }
  return asImage(narrow);
}

Result<DepthValues> decodeDepth(Bytes png) {
  const cv::Mat values = decodeByOpenCv(png, cv::IMREAD_UNCHANGED);
  if (values.empty()) return damaged();
  if (values.type() != CV_16UC1) {
    return Status::invalidInput("has no single channel of 16 bits; it is no depth image");
  }
  return DepthValues{
      values.cols, values.rows, {values.begin<std::uint16_t>(), values.end<std::uint16_t>()}};
}

}  // namespace tolman::coded_images
