// SPDX-License-Identifier: BSD-3-Clause
// The images of a source as the stages get them: rectified, then cropped and scaled down.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/fields.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

/// Makes the rectified image from a raw one. The positions in the raw image from which the pixels
/// are interpolated are computed once.
class PixelMap {
 public:
  PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
           const CameraRig& rectified);

  /// Bilinear, in steps of 1/64 px; black where the raw image shows nothing. Rows are computed in
  /// parallel; the bytes are the same for any number of threads and any processor. For a raw image
  /// of another size than the map's the result is empty.
  Image apply(const Image& raw) const;
  /// The same for an array with a value per pixel, with the shape (rows, columns) of raw images:
  /// the nearest value, 0 where there is none. Other arrays are unchanged.
  void apply(NamedArray& values) const;

 private:
  /// The raw pixel above and left of a position.
  struct RawPixel {
    std::uint16_t x = 0;
    std::uint16_t y = 0;
  };
  static constexpr std::uint8_t kNowhere = 255;

  std::size_t firstOf(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
  }
  template <int Channels>
  void interpolateRow(const Image& raw, int row, std::uint8_t* out) const;

  int raw_width_;
  int raw_height_;
  int width_;
  int height_;
  std::vector<RawPixel> pixels_;     ///< row by row; likewise the next two
  std::vector<std::uint8_t> right_;  ///< share of the pixels to the right, in 1/64; or kNowhere
  std::vector<std::uint8_t> below_;  ///< share of the pixels below, likewise
};

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

/// Crops and scales down images, and adapts their calibration.
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
