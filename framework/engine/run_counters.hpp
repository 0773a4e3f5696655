// SPDX-License-Identifier: BSD-3-Clause
// Counts of a run.
#pragma once

#include <cstdint>
#include <string_view>

namespace tolman::pipeline {

inline constexpr std::string_view kNeverTracked =
    "no motion in the whole run; are the images rectified, and left and right not exchanged? see "
    "`tolman dataset check`";

inline constexpr std::string_view kNeverTrackedSingle =
    "no motion in the whole run; are the images those of the calibration, and does the camera move "
    "sideways or forward, not only turn? see `tolman dataset check`";

inline constexpr std::string_view kNeverTrackedDepth =
    "no motion in the whole run; are the depth images sound, in the unit that the source is told, "
    "and aligned with the images? see `tolman dataset check`";

inline constexpr std::string_view kNoImages =
    "no motion in the whole run: the last frame has no image; take a source that gives images, or "
    "an odometry that works without them, such as motion_replay";

inline constexpr std::string_view kNearlyBlack =
    "no motion in the whole run: the images are nearly black, with hardly any grey level above 63; "
    "if their files have 16 bits of which the camera uses fewer, set source.bits, see log.txt; "
    "otherwise expose them longer";

inline constexpr std::string_view kLostInTheDark =
    "odometry was lost at the end: most images without tracking are nearly black, with hardly any "
    "grey level above 63; if their files have 16 bits of which the camera uses fewer, set "
    "source.bits, see log.txt; otherwise expose them longer";

inline constexpr std::string_view kOneFrame =
    "no motion in the whole run: it has one frame, and motion is found between two; take more";

inline constexpr std::string_view kMostlyImpossible =
    "no motion in the whole run: most motions exceed the limits of `checks`, see log.txt; correct "
    "the limits, or the time stamps, the frame rate or the units of the source";

inline constexpr std::string_view kStoodStill =
    "no motion in the whole run: odometry answered exactly zero at each frame; if the camera "
    "moved, see `tolman dataset check`, and `tolman plugins validate` for the plugin";

/// The images that a frame has.
enum class Views : std::uint8_t { Pair, Single, Depth, None };

/// Counters of the health of a run.
struct RunCounters {
  std::int64_t frames = 0;      ///< processed
  std::int64_t dropped = 0;     ///< realtime: never processed
  std::int64_t skipped = 0;     ///< frames at which a stage failed and the run continued
  std::int64_t impossible = 0;  ///< motions that `checks` replaced by a prediction, and frames with
                                ///< a revision that they left out
  std::int64_t defects = 0;     ///< frames whose images are missing or faulty (Frame::defect)
  std::int64_t initialising = 0;    ///< frames before odometry gave a motion; at least the first
  std::int64_t lost = 0;            ///< frames with odometry lost
  std::int64_t nearly_black = 0;    ///< frames without tracking, see imaging::isNearlyBlack()
  std::int64_t unmoved = 0;         ///< tracked frames whose motion is exactly zero
  std::int64_t place_left_out = 0;  ///< realtime: frames without place recognition
  std::int64_t templates = 0;       ///< with those of earlier sessions
  std::int64_t experiences = 0;     ///< of the newest published graph, at the end the final one
  std::int64_t loop_decisions = 0;  ///< Action::CloseLoop, also those that the map rejects later
  std::int64_t links = 0;           ///< of the same graph as experiences, without rejected ones
  std::int64_t loop_links = 0;      ///< those of kind LinkKind::Loop
  bool lost_at_end = false;
  Views views =
      Views::Pair;  ///< of the newest frame without a defect, for a hint; no count, not visited

  /// Calls visit(name, value) for each count.
  template <class Self, class Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("frames", self.frames);
    visit("dropped", self.dropped);
    visit("skipped", self.skipped);
    visit("impossible", self.impossible);
    visit("defects", self.defects);
    visit("initialising", self.initialising);
    visit("lost", self.lost);
    visit("nearly_black", self.nearly_black);
    visit("unmoved", self.unmoved);
    visit("place_left_out", self.place_left_out);
    visit("templates", self.templates);
    visit("experiences", self.experiences);
    visit("loop_decisions", self.loop_decisions);
    visit("links", self.links);
    visit("loop_links", self.loop_links);
    visit("lost_at_end", self.lost_at_end);
  }

  std::int64_t tracked() const { return frames - initialising - lost; }
  /// Whether no motion was found in the whole run.
  bool neverTracked() const { return frames > 0 && tracked() == unmoved; }
  /// The warning for a run that never tracked, by its likely cause.
  std::string_view neverTrackedText() const {
    if (frames == 1) return kOneFrame;
    if (2 * impossible > frames) return kMostlyImpossible;
    if (2 * nearly_black > frames) return kNearlyBlack;
    return unmoved > 0 ? kStoodStill : neverTrackedByViews();
  }
  std::string_view neverTrackedByViews() const {
    switch (views) {
      case Views::Single:
        return kNeverTrackedSingle;
      case Views::Depth:
        return kNeverTrackedDepth;
      case Views::None:
        return kNoImages;
      case Views::Pair:
        break;
    }
    return kNeverTracked;
  }
  /// The same also for a run that tracked and was lost at its end; empty if no cause is known.
  std::string_view endText() const {
    if (neverTracked()) return neverTrackedText();
    const bool dark = lost_at_end && 2 * nearly_black > lost + initialising;
    return dark ? kLostInTheDark : std::string_view();
  }
};

}  // namespace tolman::pipeline
