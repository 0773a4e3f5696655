// SPDX-License-Identifier: BSD-3-Clause
#include "engine/frame_records.hpp"

namespace tolman::engine {

std::string_view RunCounters::endText() const {
  if (!neverTracked()) {
    const bool dark = lost_at_end && 2 * nearly_black > lost + initialising;
    return dark ? "odometry was lost at the end: most images without tracking are nearly black; if "
                  "their files have 16 bits of which the camera uses fewer, set source.bits, see "
                  "log.txt; otherwise expose them longer"
                : "";
  }
  if (frames == 1) {
    return "no motion in the whole run: it has one frame, and motion is found between two; take "
           "more";
  }
  if (2 * impossible > frames) {
    return "no motion in the whole run: most motions exceed the limits of `checks`, see log.txt; "
           "correct the limits, or the time stamps, the frame rate or the units of the source";
  }
  if (2 * nearly_black > frames) {
    return "no motion in the whole run: the images are nearly black; if their files have 16 bits "
           "of which the camera uses fewer, set source.bits, see log.txt; otherwise expose them "
           "longer";
  }
  if (unmoved > 0) {
    return "no motion in the whole run: odometry answered exactly zero at each frame; if the "
           "camera moved, see `tolman dataset check`, and `tolman plugins validate` for the plugin";
  }
  switch (views) {
    case Views::Single:
      return "no motion in the whole run; are the images those of the calibration, and does the "
             "camera move sideways or forward, not only turn? see `tolman dataset check`";
    case Views::Depth:
      return "no motion in the whole run; are the depth images sound, in the unit that the source "
             "expects, and aligned with the images? see `tolman dataset check`";
    case Views::None:
      return "no motion in the whole run: the last frame has no image; take a source that gives "
             "images, or an odometry that works without them, such as motion_replay";
    case Views::Pair:
      break;
  }
  return "no motion in the whole run; are the images rectified, and left and right not exchanged? "
         "see `tolman dataset check`";
}

}  // namespace tolman::engine
