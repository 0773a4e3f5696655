// SPDX-License-Identifier: BSD-3-Clause
// Crops and scales down the images of a source, and adapts their calibration.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/fields.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

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
