// SPDX-License-Identifier: BSD-3-Clause
#include "app/duration_text.hpp"

#include <catch2/catch.hpp>
#include <limits>

using tolman::app::durationText;

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
