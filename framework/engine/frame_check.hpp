// SPDX-License-Identifier: BSD-3-Clause
// Checks the images of each frame before the stages get them, for faults that odometry may mistake
// for motion: a camera that repeats its last image, a right image that equals the left one,
// exchanged images, a right image of another time, or one with shifted rows.
#pragma once

#include <optional>
#include <string>

#include "engine/stereo_check.hpp"
#include "tolman/records.hpp"

namespace tolman::imaging {

class FrameCheck {
 public:
  /// Call it with each frame, in order. If the images have a fault, both are removed, or only the
  /// right one is made black; `defect` then says why. Returns a note where a fault begins.
  std::optional<std::string> check(Frame& frame);

 private:
  enum class Use { Both, Left, None };
  enum class Fault { None, Left, Right, Equal, Exchanged, RowsApart, OtherTime };
  struct Verdict {
    Fault fault = Fault::None;
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
  Fault last_ = Fault::None;  ///< of the last frame
};

}  // namespace tolman::imaging
