// SPDX-License-Identifier: BSD-3-Clause
// The images of a source as the stages get them: masked, rectified, cropped and scaled down. OpenCV
// makes them, with the same bytes for any number of threads.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/fields.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

/// Parts of the images that do not show the scene, such as the own bonnet or a printed time. Stages
/// would take them for standing still; they get a smooth continuation of what is around them.
class ImageMask {
 public:
  ImageMask() = default;  ///< leaves images unchanged

  /// Rectangles in the images of `rig`: left, top, width and height of each, px. A failure says
  /// what is wrong, and what to do.
  static Result<ImageMask> create(const CameraRig& rig, const std::vector<double>& rectangles);

  bool isEmpty() const { return known_.empty(); }
  /// A copy in which each masked pixel is the mean of the nearest others, the coarser the farther
  /// they are. Images of another size are unchanged.
  Image apply(const Image& image) const;

 private:
  cv::Mat known_;  ///< 0 where the scene is hidden, else 255
};

/// Makes the rectified image from a raw one. The positions in the raw image from which the pixels
/// are interpolated are computed once.
class PixelMap {
 public:
  PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
           const CameraRig& rectified);

  /// Bilinear, in steps of 1/32 px; black where the raw image shows nothing. For a raw image of
  /// another size than the map's the result is empty.
  Image apply(const Image& raw) const;
  /// The same for an array with a value per pixel, with the shape (rows, columns) of raw images:
  /// the nearest value, 0 where there is none. Other arrays are unchanged.
  void apply(NamedArray& values) const;

 private:
  cv::Size raw_size_;
  cv::Mat pixels_;   ///< the raw pixel above and left of each position
  cv::Mat shares_;   ///< of the pixels to the right and below, as cv::convertMaps() codes them
  cv::Mat nearest_;  ///< raw pixels
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
  /// area that it covers. Empty images stay empty.
  Image apply(const Image& image) const;
  /// The same for an array with a value per pixel, with the shape (rows, columns) of the images;
  /// other arrays are unchanged. It takes the value at the centre: a mean over an edge of depth
  /// would be on no surface.
  void apply(NamedArray& values) const;

 private:
  bool isScaled() const { return rig_.width != part_.width || rig_.height != part_.height; }

  bool is_whole_ = true;
  CameraRig old_;
  CameraRig rig_;
  cv::Rect part_;  ///< of the old images
};

}  // namespace tolman::engine
