// SPDX-License-Identifier: BSD-3-Clause
#include "app/png_encoder.hpp"

#include <png.h>
#include <zlib.h>

#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <vector>

namespace tolman::dataset {
namespace {

/// Pixels and format for libpng. Rows of 16-bit pixels are in the machine's byte order.
struct Raster {
  int width = 0;
  int height = 0;
  int bits = 8;
  int colour_type = PNG_COLOR_TYPE_GRAY;
  /// For noisy photographs run lengths alone are best: for KITTI images the files are smaller than
  /// with a dictionary search and take two thirds of the time. Depth maps are repetitive and need
  /// the dictionary search.
  int strategy = Z_RLE;
  std::vector<const std::uint8_t*> rows;
};

/// Data of libpng's callbacks.
struct Sink {
  std::string bytes;
  std::string error;
};

void append(png_structp png, png_bytep data, std::size_t size) {
  bool stored = false;
  try {
    static_cast<Sink*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<char*>(data), size);
    stored = true;
  } catch (...) {  // no exception may cross libpng
  }
  if (!stored) png_error(png, "no memory");
}

void flush(png_structp) {}

void fail(png_structp png, png_const_charp message) {
  static_cast<Sink*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

/// False after an error. libpng returns here by longjmp(), so this function must have no local
/// objects with destructors.
bool writeAll(png_structp png, png_infop info, const Raster& raster) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(raster.width),
               static_cast<png_uint_32>(raster.height), raster.bits, raster.colour_type,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, Z_BEST_SPEED);
  png_set_compression_strategy(png, raster.strategy);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_write_info(png, info);
  if (raster.colour_type == PNG_COLOR_TYPE_RGB) png_set_bgr(png);
  if (raster.bits == 16) png_set_swap(png);  // files are big-endian, this machine is little-endian
  for (const std::uint8_t* row : raster.rows) png_write_row(png, row);
  png_write_end(png, info);
  return true;
}

Result<std::string> encode(const Raster& raster) {
  Sink sink;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, fail, ignoreWarning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  bool written = false;
  if (info != nullptr) {
    sink.bytes.reserve(static_cast<std::size_t>(raster.width) *
                       static_cast<std::size_t>(raster.height));
    png_set_write_fn(png, &sink, append, flush);
    written = writeAll(png, info, raster);
  } else {
    sink.error = "no memory";
  }
  png_destroy_write_struct(&png, &info);
  if (!written) return Status::failed("the image cannot be encoded as PNG: " + sink.error);
  return std::move(sink.bytes);
}

std::uint16_t depthPixel(float metres) {
  const double steps = std::round(256.0 * static_cast<double>(metres));
  return steps >= 1 && steps <= 65535 ? static_cast<std::uint16_t>(steps) : std::uint16_t{0};
}

}  // namespace

Result<std::string> encodePng(const Image& image) {
  Raster raster;
  raster.width = image.width();
  raster.height = image.height();
  if (image.format() == PixelFormat::Bgr8) raster.colour_type = PNG_COLOR_TYPE_RGB;
  for (int r = 0; r < image.height(); ++r) raster.rows.push_back(image.row(r));
  return encode(raster);
}

Result<std::string> encodeDepthPng(const NamedArray& depth) {
  const bool plane = depth.shape.size() == 2 && depth.shape[0] > 0 && depth.shape[1] > 0;
  const std::size_t width = plane ? static_cast<std::size_t>(depth.shape[1]) : 0;
  if (!plane || depth.values.size() != width * static_cast<std::size_t>(depth.shape[0])) {
    return Status::invalidInput("'" + depth.name + "' has not the shape {height, width}");
  }
  std::vector<std::uint16_t> pixels;
  pixels.reserve(depth.values.size());
  for (const float metres : depth.values) pixels.push_back(depthPixel(metres));
  Raster raster;
  raster.width = depth.shape[1];
  raster.height = depth.shape[0];
  raster.bits = 16;
  raster.strategy = Z_DEFAULT_STRATEGY;
  for (std::size_t start = 0; start < pixels.size(); start += width) {
    raster.rows.push_back(reinterpret_cast<const std::uint8_t*>(&pixels[start]));
  }
  return encode(raster);
}

}  // namespace tolman::dataset
