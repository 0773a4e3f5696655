// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <sstream>

#include "app/program.hpp"

using namespace tolman;

namespace {

struct HandClock : Clock {
  std::int64_t now_ns = 0;
  std::int64_t steadyNs() const override { return now_ns; }
};

/// Ten frames, one a second.
std::string shown(app::Terminal terminal, std::int64_t total, int frames = 10) {
  std::ostringstream out;
  HandClock clock;
  {
    app::ProgressLine line(out, clock, terminal, total);
    for (int i = 0; i < frames; ++i) {
      clock.now_ns += 1'000'000'000;
      line.step();
    }
  }
  return out.str();
}

}  // namespace

TEST_CASE("a duration has the unit that fits it") {
  CHECK(durationText(0) == "0.0 s");
  CHECK(durationText(3.7) == "3.7 s");
  CHECK(durationText(59.94) == "59.9 s");
  CHECK(durationText(59.96) == "1:00 min");  // never 60.0 s
  CHECK(durationText(64.4) == "1:04 min");
  CHECK(durationText(3599.4) == "59:59 min");
  CHECK(durationText(3599.6) == "1:00 h");  // never 60:00 min
  CHECK(durationText(3720) == "1:02 h");
  CHECK(durationText(100 * 3600) == "100:00 h");
}

TEST_CASE("what is no duration is none") {
  CHECK(durationText(-1) == "0.0 s");
  CHECK(durationText(std::numeric_limits<double>::quiet_NaN()) == "0.0 s");
}

TEST_CASE("without a terminal there is a line each tenth, or every five seconds") {
  CHECK(shown({false, false}, 20) ==
        "frame 2 of 20 (10 %), 1.0 frames/s, 18.0 s left\n"
        "frame 4 of 20 (20 %), 1.0 frames/s, 16.0 s left\n"
        "frame 6 of 20 (30 %), 1.0 frames/s, 14.0 s left\n"
        "frame 8 of 20 (40 %), 1.0 frames/s, 12.0 s left\n"
        "frame 10 of 20 (50 %), 1.0 frames/s, 10.0 s left\n");
  CHECK(shown({false, false}, -1) == "frame 5, 1.0 frames/s\nframe 10, 1.0 frames/s\n");
}

TEST_CASE("on a terminal one line is redrawn, and wiped in the end") {
  const std::string text = shown({true, false}, 20);
  CHECK(text.find('\n') == std::string::npos);
  CHECK(text.find("frame 10 of 20 (50 %), 1.0 frames/s, 10.0 s left") != std::string::npos);
  CHECK(text.ends_with(" \r"));
}

TEST_CASE("quiet means silence") {
  CHECK(shown({false, true}, 20).empty());
  CHECK(shown({true, true}, 20).empty());
}
