// SPDX-License-Identifier: BSD-3-Clause
// Counts of a run, and what they say where it found no motion.
#pragma once

#include <cstdint>
#include <string_view>

namespace tolman::engine {

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
  std::int64_t nearly_black = 0;    ///< frames without tracking, see isNearlyBlack()
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
  /// The warning for a run that never tracked, or was lost at its end, by the likely cause; empty
  /// if there is none.
  std::string_view endText() const;
};

}  // namespace tolman::engine
