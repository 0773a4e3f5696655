// SPDX-License-Identifier: BSD-3-Clause
// Whether images of 16 bits use only the lower ones, as those of most cameras of 10, 12 or 14 bits
// do: taken as 16 bits, they are nearly black.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "value_widths.hpp"

namespace tolman::source_parameters {

/// The largest values of the images of a source, in the order in which it gives them; one in ten
/// thousand values may be larger, because a single hot pixel says nothing of the others.
class UsedBits {
 public:
  static constexpr int kJudged = 10;  ///< images; dataset check and init read as many pairs

  /// `bits`: the parameter of the source.
  explicit UsedBits(int bits = 16) : bits_(bits) {}

  /// Whether the widths of further images matter: not after a warning.
  bool isJudging() const { return !is_told_; }

  /// Counts an image by its values of 16 bits; without values it is an image of 8 bits.
  void add(const ValueWidths& widths) {
    const int usual = widths.usual();
    if (usual < 0) return;
    if (++images_ <= kJudged) first_.add(usual, widths.largest());
    if (usual == 0) return;  // black: says nothing of the camera
    if (usual >> (bits_ - kLateBits) != 0) {
      brightest_ = std::max(brightest_, usual);
      late_ = {};
    } else if (late_.images < kJudged) {
      late_.add(usual, widths.largest());
    }
  }

  /// Once, if a value needs more than `bits`: a warning that follows the name of the image.
  std::optional<std::string> beyond(int largest) {
    if (is_beyond_told_ || largest < 0 || largest >> bits_ == 0) return std::nullopt;
    is_beyond_told_ = true;
    return "has values of more than " + std::to_string(bits_) +
           " bits, which become white (255); set bits to as many as the camera has, or remove it";
  }

  /// Once: a warning without the name of a file. Either after the first kJudged images, or after
  /// fewer if no more come (`is_last`), if none of their values fills a quarter of `bits`; or after
  /// kJudged in a row (half as many at the last) that do not fill a sixteenth, where earlier ones
  /// did. `frame`: of the image that was added last. Nothing of images that are black.
  std::optional<std::string> warning(bool is_last, std::int64_t frame) {
    if (is_told_ || images_ == 0) return std::nullopt;
    std::optional<std::string> told;
    if (images_ >= kJudged || is_last) told = firstWarning();
    if (!told && (late_.images == kJudged || (is_last && 2 * late_.images >= kJudged))) {
      told = lateWarning(frame);
    }
    is_told_ = told.has_value();
    return told;
  }

 private:
  /// Images that are judged together.
  struct Series {
    int images = 0;
    int largest = 0;       ///< of the usual values
    bool has_hot = false;  ///< larger values were left out

    void add(int usual, int largest_of_all) {
      ++images;
      largest = std::max(largest, usual);
      has_hot = has_hot || usual < largest_of_all;
    }
  };

  // A shadow may dim a scene to a quarter, so later images must be darker to count. Chosen, not
  // tuned: cameras of 12 bits and fewer stay below a sixteenth of 16 bits.
  static constexpr int kLateBits = 4;

  /// The least number of bits of a camera that holds the values; 0 if none is well below `bits`.
  int fitting(int largest) const {
    constexpr std::array kUsual = {8, 10, 12, 14};  // of cameras
    const auto* const fits = std::ranges::find_if(kUsual, [&](int b) { return largest >> b == 0; });
    return largest == 0 || fits == kUsual.end() || *fits > bits_ - 2 ? 0 : *fits;
  }

  /// "the values of the first 10 images of 16 bits stay below 4096, so that ..."
  std::string lowText(const Series& series, int fits, const std::string& which) const {
    return std::string(series.has_hot ? "nearly all" : "the") + " values of " + which +
           " stay below " + std::to_string(1 << fits) + ", so that " +
           (series.has_hot ? "hardly any" : "no") + " grey level is above " +
           std::to_string(series.largest >> (bits_ - 8)) + " of 255";
  }

  std::optional<std::string> firstWarning() const {
    const int fits = fitting(first_.largest);
    if (fits == 0) return std::nullopt;
    return lowText(first_, fits,
                   "the first " + std::to_string(first_.images) + " images of 16 bits") +
           "; set source.bits=" + std::to_string(fits) +
           " (in a command without configuration: bits=" + std::to_string(fits) +
           "), unless the scene is that dark";
  }

  std::optional<std::string> lateWarning(std::int64_t frame) const {
    const int fits = fitting(late_.largest);
    if (fits == 0) return std::nullopt;
    return lowText(late_, fits,
                   std::to_string(late_.images) +
                       " images of 16 bits in a row, the last at frame " + std::to_string(frame) +
                       ",") +
           ", where earlier values reach " + std::to_string(brightest_) +
           "; if the camera was set to fewer bits there, read those images in a run of their own "
           "with source.bits=" +
           std::to_string(fits) + ", unless the scene is that dark";
  }

  int bits_;
  int images_ = 0;
  int brightest_ = 0;  ///< of the usual values of all images
  Series first_;       ///< the first kJudged images
  Series late_;        ///< the last ones in a row that do not fill a sixteenth of `bits`
  bool is_told_ = false;
  bool is_beyond_told_ = false;
};

}  // namespace tolman::source_parameters
