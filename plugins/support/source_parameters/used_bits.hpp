// SPDX-License-Identifier: BSD-3-Clause
// Whether images of 16 bits use only the lower ones, as those of most cameras of 10, 12 or 14 bits
// do: taken as 16 bits, they are nearly black.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "value_widths.hpp"

namespace tolman::source_parameters {

/// The largest values of the images of a source, in the order in which it gives them; one in ten
/// thousand values may be larger, because a single hot pixel says nothing of the others.
class UsedBits {
 public:
  static constexpr int kJudged = 10;  ///< images; dataset check and init read as many pairs

  /// Whether images that are added still count.
  bool isJudging() const { return images_ < kJudged; }

  /// Counts an image of 16 bits. `largest`: of its values, or negative for other images.
  void add(int largest) {
    if (largest < 0 || !isJudging()) return;
    ++images_;
    largest_ = std::max(largest_, largest);
  }

  /// The same without the few largest values; nothing without values.
  void add(const ValueWidths& widths) {
    if (isJudging() && widths.usual() < widths.largest()) has_hot_ = true;
    add(widths.usual());
  }

  /// Once, if a value needs more than `bits`: a warning that follows the name of the image.
  std::optional<std::string> beyond(int largest, int bits) {
    if (is_beyond_told_ || largest < 0 || largest >> bits == 0) return std::nullopt;
    is_beyond_told_ = true;
    return "has values of more than " + std::to_string(bits) +
           " bits, which become white (255); set bits to as many as the camera has, or remove it";
  }

  /// Once, after kJudged images, or after fewer if no more come (`is_last`): a warning without the
  /// name of a file if no value of them fills a quarter of the parameter `bits`. Nothing of images
  /// that are black: they say nothing of the camera.
  std::optional<std::string> warning(int bits, bool is_last) {
    if (is_told_ || images_ == 0 || (images_ < kJudged && !is_last)) return std::nullopt;
    is_told_ = true;
    constexpr std::array kUsual = {8, 10, 12, 14};  // of cameras
    const auto* const fits =
        std::ranges::find_if(kUsual, [&](int b) { return largest_ >> b == 0; });
    if (largest_ == 0 || fits == kUsual.end() || *fits > bits - 2) return std::nullopt;
    const std::string brightest = std::to_string(largest_ >> (bits - 8));
    return std::string(has_hot_ ? "nearly all" : "the") + " values of the first " +
           std::to_string(images_) + " images of 16 bits stay below " + std::to_string(1 << *fits) +
           ", so that no grey level is above " + brightest +
           " of 255; set source.bits=" + std::to_string(*fits) +
           " (in a command without configuration: bits=" + std::to_string(*fits) +
           "), unless the scene is that dark";
  }

 private:
  int images_ = 0;
  int largest_ = 0;
  bool has_hot_ = false;  ///< larger values were left out
  bool is_told_ = false;
  bool is_beyond_told_ = false;
};

}  // namespace tolman::source_parameters
