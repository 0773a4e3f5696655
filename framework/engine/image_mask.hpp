// SPDX-License-Identifier: BSD-3-Clause
// Parts of the images that do not show the scene, such as the own bonnet or a printed time. Stages
// would take them for standing still; they get a smooth continuation of what is around them.
#pragma once

#include <vector>

#include "tolman/camera.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

class ImageMask {
 public:
  ImageMask() = default;  ///< leaves images unchanged

  /// Rectangles in the images of `rig`: left, top, width and height of each, px. A failure says
  /// what is wrong, and what to do.
  static Result<ImageMask> create(const CameraRig& rig, const std::vector<double>& rectangles);

  bool isEmpty() const { return levels_.empty(); }
  /// A copy in which each masked pixel is the mean of the nearest others, the coarser the farther
  /// they are. Images of another size are unchanged.
  Image apply(const Image& image) const;

 private:
  /// The mask, and its halves: a pixel is unknown where all that it covers are.
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<char> known;
  };
  std::vector<float> halved(const std::vector<float>& pixels, std::size_t level) const;
  void fill(std::vector<float>& pixels, std::size_t level) const;

  std::vector<Level> levels_;  ///< none: there is no mask
};

/// Detects that every second image has more texture: a projector of dots that is on for every
/// second pair (`emitter_on_off`), or two exposures. The dots stand still in the camera.
class Alternation {
 public:
  /// Whether this image makes it certain: true at most once.
  bool add(const Image& image);
  /// 0 or 1: the first of the images with less texture.
  int first() const { return first_; }

 private:
  std::vector<double> textures_;
  int first_ = 0;
};

}  // namespace tolman::engine
