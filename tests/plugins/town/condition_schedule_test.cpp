// SPDX-License-Identifier: BSD-3-Clause
// Light at each frame, by conditions, and its changes between them.
#include "condition_schedule.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman;
using namespace tolman::town;

namespace {

ConditionSchedule schedule(const std::string& conditions) {
  TownParameters parameters;
  parameters.conditions = conditions;
  return ConditionSchedule::make(parameters, builtInRoute("block", {}).value()).value();
}

}  // namespace

TEST_CASE("without conditions the light is that of the parameters") {
  const ConditionSchedule plain = schedule("");
  const Light light = plain.lightAt(100);
  const TownParameters defaults;
  const Light wanted = makeLight(defaults.hour, defaults.weather, defaults.haze, light.seed);
  CHECK(light.sun == wanted.sun);
  CHECK(light.sky == wanted.sky);
  CHECK(light.lamps == 0);
  CHECK(light.wet == 0);
  CHECK(light.dimness == 1);
  CHECK_FALSE(plain.anyBare());
  CHECK_FALSE(plain.anyExchanged());
}

TEST_CASE("night is dark with lamps on, rain wets, snow covers") {
  const Light night = schedule("all = night").lightAt(5);
  CHECK(night.lamps == 1);
  CHECK(night.sun == 0);
  CHECK(night.sky < 0.01F);
  CHECK(night.dimness > 5);
  const Light rain = schedule("all = rain").lightAt(5);
  CHECK(rain.wet == 1);
  CHECK(rain.rain == 1);
  CHECK(rain.haze > night.haze);
  CHECK(schedule("all = snow").lightAt(5).snow == 1);
  CHECK(schedule("pass 2 = bare").anyBare());
  CHECK(schedule("pass 2 = exchanged").anyExchanged());
  CHECK_FALSE(schedule("pass 7 = bare").anyBare());  // block has two
}

TEST_CASE("light changes step by step over 20 m") {
  const ConditionSchedule change = schedule("100-400 m = night");
  const std::vector<double> driven = drivenMetres(builtInRoute("block", {}).value());
  float before = 0;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const float lamps = change.lightAt(i).lamps;
    CHECK(lamps >= before);
    CHECK(lamps - before < 0.1F);
    if (driven[i] < 89) CHECK(lamps == 0);
    if (driven[i] > 111) CHECK(lamps == 1);
    before = lamps;
  }
  CHECK(before == 1);
}

TEST_CASE("what is wrong is refused") {
  TownParameters parameters;
  parameters.conditions = "tomorrow = sun";
  CHECK_FALSE(ConditionSchedule::make(parameters, builtInRoute("block", {}).value()).isOk());
}
