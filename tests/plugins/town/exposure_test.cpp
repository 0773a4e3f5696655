// SPDX-License-Identifier: BSD-3-Clause
#include "exposure.hpp"

#include <catch2/catch.hpp>

using namespace tolman::town;

TEST_CASE("without a time at noon exposure does not depend on the light") {
  const Exposure off = exposureFor(makeLight(23, Weather::Fog, 0, 1), 0, 2);
  CHECK(off.time_ms == 0);
  CHECK(off.amplification == 1);
}

TEST_CASE("less light is exposed longer, and amplified beyond the longest time") {
  const auto at = [](double hour) {
    return exposureFor(makeLight(hour, Weather::Clear, 0, 1), 0.5, 2);
  };
  CHECK(at(12).time_ms == Approx(0.5));
  CHECK(at(12).amplification == Approx(1));
  CHECK(at(18).time_ms > 0.55);
  const Exposure night = at(0);
  CHECK(night.time_ms == 2);
  CHECK(night.amplification > 5);
  // Time times amplification grows as the light shrinks.
  const auto light = [](double hour) {
    return static_cast<double>(makeLight(hour, Weather::Clear, 0, 1).onto({0, 0, 1}, 1));
  };
  CHECK(night.time_ms * night.amplification == Approx(0.5 * light(12) / light(0)).epsilon(1e-4));
}
