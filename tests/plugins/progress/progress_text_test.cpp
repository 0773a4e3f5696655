// SPDX-License-Identifier: BSD-3-Clause
// The texts of the display, compared with the expected ones.
#include "progress_text.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace tolman::progress {
namespace {

const ProgressState kMiddle = {.frames = 215,
                               .total = 509,
                               .seconds = 21.5,
                               .templates = 31,
                               .experiences = 20,
                               .loop_decisions = 1,
                               .loop_links = 1};

}  // namespace

TEST_CASE("the bar line takes what the terminal has room for") {
  CHECK(barLine(kMiddle, 200) ==
        "[===============>                        ] 42 %  215/509  10.0 frames/s  29.4 s left  "
        "31 templates  20 experiences  1 loop decision");
  CHECK(barLine(kMiddle, 109) ==
        "[======>          ] 42 %  215/509  10.0 frames/s  29.4 s left  31 templates  20 "
        "experiences  1 loop decision");
  CHECK(barLine(kMiddle, 80) ==
        "[=======>             ] 42 %  215/509  10.0 frames/s  29.4 s left  31 templates");
  CHECK(barLine(kMiddle, 40) == "[========>              ] 42 %  215/509");
  CHECK(barLine(kMiddle, 20) == "[====>       ] 42 %");
  CHECK(barLine(kMiddle, 10) == "42 %");
  CHECK(barLine(kMiddle, 0).empty());
}

TEST_CASE("the bar line never reaches the last column, where terminals wrap") {
  for (int width = 0; width < 160; ++width) {
    CAPTURE(width);
    CHECK(static_cast<int>(barLine(kMiddle, width).size()) <= std::max(width - 1, 0));
  }
}

TEST_CASE("the ends of the bar") {
  CHECK(barLine({.frames = 0, .total = 51}, 30) == "[                 ] 0 %  0/51");
  CHECK(barLine({.frames = 51, .total = 51, .seconds = 5}, 30) == "[==============] 100 %  51/51");
  CHECK(barLine({.frames = 60, .total = 51, .seconds = 5}, 30) == "[==============] 100 %  60/51");
}

TEST_CASE("without a known end there is no bar and no time left") {
  CHECK(barLine({.frames = 7, .total = -1, .seconds = 2}, 70) ==
        "7 frames  3.5 frames/s  0 templates  0 experiences  0 loop decisions");
  CHECK(plainLine({.frames = 7, .total = -1, .seconds = 2}) ==
        "frame 7, 3.5 frames/s, 0 templates, 0 experiences, 0 loop decisions");
}

TEST_CASE("colour wraps the filled part only") {
  CHECK(coloured("[==>   ] 50 %") == "[\x1b[32m==>\x1b[0m   ] 50 %");
  CHECK(coloured("[     ] 0 %") == "[     ] 0 %");
  CHECK(coloured("7 frames") == "7 frames");
}

TEST_CASE("lines for a log") {
  CHECK(plainLine(kMiddle) ==
        "frame 215 of 509 (42 %), 10.0 frames/s, 29.4 s left, 31 templates, 20 experiences, 1 loop "
        "decision");
  CHECK(plainLine({.frames = 1, .total = 40000, .seconds = 1}) ==
        "frame 1 of 40000 (0 %), 1.0 frames/s, 11:07 h left, 0 templates, 0 experiences, 0 loop "
        "decisions");
  CHECK(summaryLine(kMiddle) ==
        "215 frames in 21.5 s, 10.0 frames/s, 31 templates, 20 experiences, 1 loop link");
  CHECK(summaryLine({.frames = 1, .total = 1, .seconds = 0}) ==
        "1 frame in 0.0 s, 0.0 frames/s, 0 templates, 0 experiences, 0 loop links");
  CHECK(summaryLine({.frames = 51, .left_out = 43, .total = 51, .seconds = 0.3}) ==
        "8 frames processed and 43 left out in 0.3 s, 26.7 frames/s, 0 templates, 0 experiences, "
        "0 loop links");
  // The time left is that of the source's frames, the speed that of the processed ones.
  CHECK(plainLine({.frames = 50, .left_out = 40, .total = 100, .seconds = 5}) ==
        "frame 50 of 100 (50 %), 2.0 frames/s, 5.0 s left, 0 templates, 0 experiences, 0 loop "
        "decisions");
  CHECK(summaryLine({.frames = 90000, .seconds = 125}) ==
        "90000 frames in 2:05 min, 720 frames/s, 0 templates, 0 experiences, 0 loop links");
}

}  // namespace tolman::progress
