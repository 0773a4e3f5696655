// SPDX-License-Identifier: BSD-3-Clause
#include "app/progress_line.hpp"

#include <catch2/catch.hpp>
#include <sstream>

using namespace tolman;
using app::barText;
using app::plainText;

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

TEST_CASE("a bar has share, count, rate and time left, and never wraps") {
  CHECK(barText({40, 100, 4}, 80) ==
        "[=======>            ] 40 %  40/100  10.0 frames/s  6.0 s left");
  CHECK(barText({0, 100, 0}, 80) == "[                    ] 0 %  0/100  0.0 frames/s");
  CHECK(barText({100, 100, 10}, 80) ==
        "[====================] 100 %  100/100  10.0 frames/s  0.0 s left");
  CHECK(barText({7, -1, 2}, 80) == "7 frames  3.5 frames/s");
  CHECK(barText({40, 100, 4}, 30).size() == 29);
  CHECK(barText({40, 100, 4}, 0).empty());
}

TEST_CASE("a plain line says the same in words") {
  CHECK(plainText({40, 100, 4}) == "frame 40 of 100 (40 %), 10.0 frames/s, 6.0 s left");
  CHECK(plainText({1, 4541, 1}) == "frame 1 of 4541 (0 %), 1.0 frames/s, 1:16 h left");
  CHECK(plainText({7, -1, 2}) == "frame 7, 3.5 frames/s");
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
  CHECK(text.find("10/20") != std::string::npos);
  CHECK(text.ends_with(" \r"));
}

TEST_CASE("quiet means silence") {
  CHECK(shown({false, true}, 20).empty());
  CHECK(shown({true, true}, 20).empty());
}
