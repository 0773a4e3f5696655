// SPDX-License-Identifier: BSD-3-Clause
// Dirt and drops of water on the glass in front of a camera, out of focus.
#pragma once

#include <cstdint>
#include <vector>

namespace tolman::town {

/// Image size and its ratio to the full size, on which the sizes of spots and drops depend.
struct GlassSize {
  int width = 0;
  int height = 0;
  double scale = 1;
};

class LensGlass {
 public:
  LensGlass() = default;
  /// `dirt`: share of the image that is dimmed; `drops`: their number at any time.
  LensGlass(const GlassSize& size, double dirt, double drops, std::uint32_t seed);

  bool isClean() const { return dirt_.empty() && drops_ == 0; }
  /// Changes the radiance to that behind the glass, `seconds` after the start. `veil`: radiance
  /// that dirt scatters.
  void apply(std::vector<float>& radiance, float veil, double seconds) const;

 private:
  struct Drop;
  Drop dropAt(std::uint32_t number, double seconds) const;
  void refract(std::vector<float>& radiance, double seconds) const;

  GlassSize size_;
  std::vector<float> dirt_;  ///< 0 clean to 1 covered, per pixel
  std::uint32_t drops_ = 0;
  std::uint32_t seed_ = 0;
};

}  // namespace tolman::town
