// SPDX-License-Identifier: BSD-3-Clause
// How images of 16 bits become images of 8. Cameras of 10, 12 or 14 bits fill only the lower ones:
// taken as 16 bits, their images are nearly black.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>

#include "tolman/context.hpp"

namespace tolman::source_parameters {

class UsedBits {
 public:
  /// `bits`: those that the camera uses, from the lowest; a parameter of the source.
  explicit UsedBits(int bits = 16) : bits_(bits) {}

  /// The pixel of a value: the 8 highest of its lowest `bits`; 255 for larger values.
  std::uint8_t convert(std::uint16_t value) {
    seen_ |= value;
    if (images_ < kJudged) ++counts_[static_cast<std::size_t>(std::bit_width(value))];
    return static_cast<std::uint8_t>(std::min(value >> (bits_ - 8), 255));
  }

  /// To be called after each image, whose file or topic is `where`. A warning, each once: values
  /// that exceed `bits`; or, after ten images, that no value fills a quarter of the range. Of ten
  /// thousand values one may be larger, because a hot pixel says nothing of the others. No warning
  /// for black images.
  std::optional<Finding> endImage(const std::string& where) {
    const bool exceeds = seen_ >> bits_ != 0 && !warned_;
    if (exceeds) {
      warned_ = true;
      images_ = kJudged;
      return Finding{
          Finding::Severity::Warning, where,
          "has values of more than " + std::to_string(bits_) + " bits, which become white (255)",
          "set bits to as many as the camera has"};
    }
    if (seen_ == 0 || images_ == kJudged || ++images_ < kJudged) return std::nullopt;
    constexpr std::array kUsual = {8, 10, 12, 14};  // bits of cameras
    const auto* const fits = std::ranges::find_if(kUsual, [&](int b) { return b >= usualWidth(); });
    if (fits == kUsual.end() || *fits > bits_ - 2) return std::nullopt;
    return Finding{Finding::Severity::Warning, where,
                   "nearly all values of the first images of 16 bits stay below " +
                       std::to_string(1 << *fits) + ", so they become dark",
                   "set source.bits=" + std::to_string(*fits) + ", unless the scene is that dark"};
  }

 private:
  static constexpr int kJudged = 10;  // images

  /// The bits that all values need but one in ten thousand.
  int usualWidth() const {
    const std::size_t all = std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
    std::size_t larger = 0;
    int width = static_cast<int>(counts_.size()) - 1;
    for (; width > 0; --width) {
      larger += counts_[static_cast<std::size_t>(width)];
      if (larger > all / 10'000) break;
    }
    return width;
  }

  int bits_;
  int images_ = 0;  ///< that were judged; images of 8 bits and black ones do not count
  int seen_ = 0;    ///< all values, joined by or
  bool warned_ = false;
  std::array<std::size_t, 17> counts_ = {};  ///< of values by the bits that they need, 0 to 16
};

}  // namespace tolman::source_parameters
