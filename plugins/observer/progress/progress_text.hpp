// SPDX-License-Identifier: BSD-3-Clause
// The texts of the progress display, from counts.
#pragma once

#include <cstdint>
#include <string>

namespace tolman::progress {

/// Counts of a run so far.
struct ProgressState {
  std::int64_t frames = 0;    ///< of the source that are behind: processed, or left out
  std::int64_t left_out = 0;  ///< of these: dropped in realtime, skipped, or without image
  std::int64_t total = -1;    ///< -1 when not known
  double seconds = 0;         ///< since the run began
  std::int64_t templates = 0;
  std::int64_t experiences = 0;
  std::int64_t loop_decisions = 0;  ///< so far, during the run
  std::int64_t loop_links = 0;      ///< of the final map
};

/// One line of at most `width` - 1 columns, for a terminal of `width` columns. Parts that do not
/// fit are left out, counts first.
std::string barLine(const ProgressState& state, int width);

/// The same line with a green bar.
std::string coloured(std::string bar_line);

/// One line for a log: "frame 20 of 51 (39 %), 9.8 frames/s, 3.2 s left, 12 templates, ...".
std::string plainLine(const ProgressState& state);

/// The last line; its speed, as in the other lines, is that of the processed frames: "51 frames
/// in 5.2 s, 9.8 frames/s, 12 templates, 8 experiences, 1 loop link", or "8 frames processed and 43
/// left out in 0.3 s, 26.7 frames/s, ...".
std::string summaryLine(const ProgressState& state);

}  // namespace tolman::progress
