// SPDX-License-Identifier: BSD-3-Clause
// Bilinear interpolation at the positions of a PixelMap: one by one, or eight neighbours at once
// where the processor has SSE4.1. Both use integer arithmetic and give the same bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/fields.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

/// Positions are rounded to this fraction of a pixel: 1/64.
constexpr int kParts = 64;

/// The position in the raw image that one pixel is interpolated from.
struct RawPosition {
  static constexpr std::uint8_t kNowhere = 255;

  std::uint16_t x = 0;  ///< the pixel above and left of the position
  std::uint16_t y = 0;
  std::uint8_t right = kNowhere;  ///< share of the pixels to the right, in 1/64
  std::uint8_t below = 0;
};

/// Eight neighbours of a row. They come from at most 16 columns of the raw image, or `rows` is 0.
struct PixelGroup {
  std::uint16_t x = 0;       ///< first column
  std::uint16_t y = 0;       ///< first row
  std::uint32_t rows = 0;    ///< number of raw rows of the upper pixels
  std::uint8_t column[8]{};  // NOLINT(modernize-avoid-c-arrays): loaded as one word
  std::uint8_t row[8]{};     // NOLINT(modernize-avoid-c-arrays)
  std::uint8_t right[8]{};   // NOLINT(modernize-avoid-c-arrays)
  std::uint8_t below[8]{};   // NOLINT(modernize-avoid-c-arrays)
};

/// The groups of one row of positions; the last positions, if fewer than eight, are in no group.
void groupPositions(std::span<const RawPosition> positions, int raw_width, PixelGroup* groups);

/// Whether the processor supports groups.
bool hasGroupInstructions();

/// Interpolates a row; `groups` null: one by one. Pixels without a position are unchanged (black).
void interpolateRow(const Image& raw, std::span<const RawPosition> positions,
                    const PixelGroup* groups, std::uint8_t* out);

// Makes the rectified image from a raw one. The positions in the raw image from which the pixels
// are interpolated are computed once.

class PixelMap {
 public:
  enum class Speed : std::uint8_t { Portable, Fastest };

  PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw, const CameraRig& rectified,
           Speed speed = Speed::Fastest);

  /// Bilinear, in steps of 1/64 px; black where the raw image shows nothing. Rows are computed in
  /// parallel; the bytes are the same for any number of threads and any processor. For a raw image
  /// of another size than the map's the result is empty.
  Image apply(const Image& raw) const;
  /// The same for an array with a value per pixel, with the shape (rows, columns) of raw images:
  /// the nearest value, 0 where there is none. Other arrays are unchanged.
  void apply(NamedArray& values) const;

 private:
  std::span<const RawPosition> positionsOf(int row) const;
  std::size_t firstGroup(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ / 8);
  }

  int raw_width_;
  int raw_height_;
  int width_;
  int height_;
  std::vector<RawPosition> positions_;  ///< row by row
  std::vector<PixelGroup> groups_;      ///< the same in groups, or none
};

// Crops and scales down the images of a source, and adapts their calibration.

/// Weights of the pixels that each new pixel covers, along one axis.
class PixelMeans {
 public:
  PixelMeans() = default;
  PixelMeans(int from, int to);

  struct Span {
    int first = 0;            ///< first covered pixel
    std::size_t weights = 0;  ///< index of its weight
    int count = 0;            ///< number of covered pixels
  };
  const Span& spanOf(int i) const { return spans_[static_cast<std::size_t>(i)]; }
  std::uint32_t weight(std::size_t i) const { return weights_[i]; }
  int size() const { return static_cast<int>(spans_.size()); }

  static constexpr int kBits = 11;  ///< the weights of a new pixel add up to 2^kBits

 private:
  std::vector<Span> spans_;
  std::vector<std::uint32_t> weights_;
};

class ImageCut {
 public:
  ImageCut() = default;  ///< leaves images unchanged

  /// `crop` is empty, or left, top, width and height in px of the images of `rig`; `scale`, at most
  /// 1, is new pixels per old one. A failure says what is wrong, and what to do.
  static Result<ImageCut> create(const CameraRig& rig, const std::vector<double>& crop,
                                 double scale);

  bool isWhole() const { return is_whole_; }
  /// The cameras of the new images.
  const CameraRig& rig() const { return rig_; }
  /// "320x240 px at (10, 20) of 640x480 px, scaled to 160x120 px"; empty for whole images.
  std::string text() const;

  /// An image of the old size, cropped (without a copy), then scaled: each pixel is the mean of the
  /// area that it covers. The same bytes for any number of threads. Empty images stay empty.
  Image apply(const Image& image) const;
  /// The same for an array with a value per pixel, with the shape (rows, columns) of the images;
  /// other arrays are unchanged. It takes the value at the centre: a mean over an edge of depth
  /// would be on no surface.
  void apply(NamedArray& values) const;

 private:
  bool is_whole_ = true;
  CameraRig old_;
  CameraRig rig_;
  int left_ = 0;  ///< px of the old images; likewise the next three
  int top_ = 0;
  int width_ = 0;
  int height_ = 0;
  PixelMeans columns_;
  PixelMeans rows_;
};

}  // namespace tolman::engine
