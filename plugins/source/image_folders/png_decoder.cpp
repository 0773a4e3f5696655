// SPDX-License-Identifier: BSD-3-Clause
#include "png_decoder.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <opencv2/imgcodecs.hpp>

#include "bytes.hpp"
#include "png_chunks.hpp"
#include "png_filters.hpp"
#include "png_inflate.hpp"
#include "png_palette.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::image_folders {
namespace {

using Bytes = std::span<const std::uint8_t>;

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
std::optional<PlainPng> readHeader(const PngChunk& chunk) {
  constexpr std::size_t kLength = 13;
  constexpr std::uint8_t kGrey = 0;
  constexpr std::uint8_t kRgb = 2;
  const Bytes header = chunk.data();
  if (chunk.name() != "IHDR" || header.size() != kLength) return std::nullopt;
  const bool is_plain = header[8] == 8 && (header[9] == kGrey || header[9] == kRgb) &&
                        header[10] == 0 && header[11] == 0 && header[12] == 0;
  if (!is_plain) return std::nullopt;
  PlainPng image;
  image.width = static_cast<std::size_t>(bigEndian(header, 0, 4));
  image.height = static_cast<std::size_t>(bigEndian(header, 4, 4));
  image.channels = header[9] == kGrey ? 1 : 3;
  return image;
}

bool isIntact(const PngChunk& chunk) {
  const Bytes checked = chunk.bytes.subspan(4, chunk.data().size() + 4);
  return libdeflate_crc32(0, checked.data(), checked.size()) == chunk.crc();
}

/// Reads header and data; nullopt for other kinds of images and for damaged ones.
std::optional<PlainPng> readChunks(Bytes png) {
  std::optional<PlainPng> image;
  std::size_t at = kPngSignature;
  for (PngChunk chunk; !(chunk = pngChunkAt(png, at)).bytes.empty(); at += chunk.bytes.size()) {
    if (!isIntact(chunk)) return std::nullopt;
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

/// Decodes with OpenCV; empty if the data are damaged.
cv::Mat decodeByOpenCv(std::vector<std::uint8_t>& png, int mode) {
  try {
    return cv::imdecode(png, mode | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
    return {};
  }
}

Status damaged() { return Status::invalidInput("cannot be decoded, its data are damaged"); }

/// The 8 highest of the lowest `bits` of each value.
cv::Mat eightBits(const cv::Mat& deep, int bits, DeepValues& values) {
  cv::Mat pixels(deep.rows, deep.cols, CV_MAKETYPE(CV_8U, deep.channels()));
  for (int r = 0; r < deep.rows; ++r) {
    const auto* from = deep.ptr<std::uint16_t>(r);
    std::transform(from, from + deep.cols * deep.channels(), pixels.ptr<std::uint8_t>(r),
                   [&](std::uint16_t v) {
                     const int value = v >> (bits - 8);
                     values.largest = std::max<int>(values.largest, v);
                     values.beyond_bits += value > 255 ? 1 : 0;
                     return static_cast<std::uint8_t>(std::min(value, 255));
                   });
    if (!values.widths) continue;
    std::for_each(from, from + deep.cols * deep.channels(),
                  [&](std::uint16_t v) { values.widths->add(v); });
  }
  return pixels;
}

}  // namespace

std::optional<Image> decodePlainPng(Bytes png, bool colour) {
  const std::optional<PlainPng> plain = readChunks(png);
  if (!plain || (plain->channels == 3) != colour) return std::nullopt;
  const auto rows = inflatePng(plain->packed, plain->size());
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

Result<Image> decodePng(std::vector<std::uint8_t>& png, bool colour, int bits, DeepValues* values) {
  removeExtras(png);
  if (std::optional<Image> image = decodePlainPng(png, colour)) return *std::move(image);
  if (exceedsPalette(png)) {
    return Status::invalidInput(
        "has pixels of colours that are not in its palette, so its data are damaged");
  }
  const cv::Mat pixels = decodeByOpenCv(png, colour ? cv::IMREAD_COLOR : cv::IMREAD_GRAYSCALE);
  if (pixels.empty()) return damaged();
  if (pixels.depth() != CV_16U) return asImage(pixels);
  DeepValues found;
  if (values != nullptr && values->widths) found.widths.emplace();
  const cv::Mat converted = eightBits(pixels, bits, found);
  if (values != nullptr) *values = found;
  return asImage(converted);
}

Result<std::vector<std::uint16_t>> decodeDeepPng(std::vector<std::uint8_t>& png) {
  removeExtras(png);
  const cv::Mat values = decodeByOpenCv(png, cv::IMREAD_UNCHANGED);
  if (values.empty()) return damaged();
  if (values.type() != CV_16UC1) {
    return Status::invalidInput("has no single channel of 16 bits; it is no depth image");
  }
  return std::vector<std::uint16_t>(values.begin<std::uint16_t>(), values.end<std::uint16_t>());
}

}  // namespace tolman::image_folders
