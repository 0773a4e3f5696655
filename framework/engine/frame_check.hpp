// SPDX-License-Identifier: BSD-3-Clause
// Checks the images of each frame before the stages get them, for faults that odometry may mistake
// for motion: a camera that repeats its last image, a right image that equals the left one,
// exchanged images, a right image of another time, or one with shifted rows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/stereo_check.hpp"
#include "tolman/records.hpp"

namespace tolman::engine {

class FrameCheck {
 public:
  /// Call it with each frame, in order. If the images have a fault, both are removed, or only the
  /// right one is made black; `defect` and the result then say why.
  std::optional<std::string> check(Frame& frame);
  /// How well the rows of the first measured pairs agree; empty if none could be measured.
  std::string rowsText() const;

 private:
  enum class Use { Both, Left, None };
  struct Verdict {
    Use use = Use::Both;
    std::string text;  ///< description of the fault
  };
  Verdict verdictOn(const Frame& frame);
  StereoFault stereoFault(const Frame& frame);

  Image left_;              ///< of the last frame that had images
  Image right_;             ///< likewise
  int until_measured_ = 0;  ///< frames
  int sound_measures_ = 0;  ///< in succession
  StereoFault last_measured_ = StereoFault::None;
  StereoFault fault_ = StereoFault::None;
  std::string stereo_text_;   ///< of the last measure with that fault
  std::vector<double> rows_;  ///< right minus left, px, of the first matched corners
};

}  // namespace tolman::engine
