// SPDX-License-Identifier: BSD-3-Clause
// The grammar of conditions, the frames at which they hold, and their light.
#include "conditions.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman;
using namespace tolman::town;

namespace {

Result<Conditions> onBlock(const std::string& text) {
  return Conditions::make(text, builtInRoute("block", {}).value(), 1);
}

Condition firstOf(const std::string& text) { return onBlock(text).value().at(0); }

std::string conditionsRefusal(const std::string& text) {
  const auto conditions = onBlock(text);
  REQUIRE_FALSE(conditions.isOk());
  return std::string(conditions.status().message());
}

}  // namespace

TEST_CASE("words change what they name, everywhere or by pass, and later ones win") {
  CHECK(firstOf("") == Condition{});
  CHECK(firstOf(" ; ") == Condition{});
  CHECK(firstOf("overcast").weather == Weather::Overcast);
  CHECK(firstOf("07:30").hour == 7.5);
  CHECK(firstOf("dusk; pass 2 = night").hour == Approx(19.3));
  CHECK(firstOf("night; pass 1-3 = 12:00 bare").hour == 12);
  CHECK_FALSE(firstOf("night; pass 1-3 = 12:00 bare").is_night);
  CHECK(firstOf("pass 1=bare snow exchanged").exchanged);
  const Conditions later = onBlock("pass 2 = night").value();
  CHECK_FALSE(later.at(0).is_night);
  CHECK(later.at(545).is_night);
  CHECK(later.any([](const Condition& c) { return c.is_night; }));
}

TEST_CASE("what is not in the grammar is refused by name") {
  for (const char* text : {"pass = night", "pass 0 = night", "pass 3-2 = night", "pass x = night",
                           "5 m = night", "pass 1 2 = night", "= night"}) {
    INFO(text);
    CHECK(conditionsRefusal(text).find("write 'pass 2 ='") != std::string::npos);
    CHECK(conditionsRefusal(text).find(text) != std::string::npos);
  }
  CHECK(conditionsRefusal("rain;wet") ==
        "conditions: 'wet': 'wet' is no condition; use 18:30, dusk, night, overcast, haze, rain, "
        "snow, bare, exchanged");
  CHECK(conditionsRefusal("25:00").find("'25:00' is no condition") != std::string::npos);
}

TEST_CASE("entries that hold at no frame are warned of") {
  CHECK(onBlock("rain; pass 2 = night").value().warnings().empty());
  CHECK(onBlock("pass 3-9 = night").value().warnings() ==
        std::vector<std::string>{"conditions: 'pass 3-9 = night' holds at no frame: a place is "
                                 "driven at most 2 times"});
}

TEST_CASE("night is dark with lamps on, rain wets, snow covers") {
  const auto light = [](const char* text) { return onBlock(text).value().lightAt(5); };
  CHECK(light("").lamps == 0);
  CHECK(light("").dimness == 1);
  CHECK(light("night").lamps == 1);
  CHECK(light("night").sun == 0);
  CHECK(light("night").sky < 0.01F);
  CHECK(light("night").dimness > 5);
  CHECK(light("rain").wet == 1);
  CHECK(light("rain").haze > light("").haze);
  CHECK(light("snow").snow == 1);
}

TEST_CASE("light changes step by step over 20 m") {
  const Conditions change = onBlock("pass 2 = night").value();
  float before = 0;
  std::size_t between = 0;
  for (std::size_t i = 0; i < 546; ++i) {
    const float lamps = change.lightAt(i).lamps;
    CHECK(lamps >= before);
    CHECK(lamps - before < 0.1F);
    between += lamps > 0 && lamps < 1;
    before = lamps;
  }
  CHECK(before == 1);
  CHECK(between > 10);
}

TEST_CASE("passes count how often a street was driven") {
  // block: 30 m over its start. eights: everything twice; crossings at a right angle do not count.
  const CameraRoute block = builtInRoute("block", {}).value();
  const std::vector<int> once = passNumbers(block);
  std::vector<double> driven = {0};
  for (std::size_t i = 1; i < block.T_town_camera.size(); ++i) {
    const Eigen::Vector3d step =
        block.T_town_camera[i].translation() - block.T_town_camera[i - 1].translation();
    driven.push_back(driven.back() + step.norm());
  }
  double again = 0;
  for (std::size_t i = 1; i < once.size(); ++i) {
    CHECK(once[i] <= 2);
    if (once[i] == 2) again += driven[i] - driven[i - 1];
    if (driven[i] < 250) CHECK(once[i] == 1);
  }
  CHECK(again == Approx(30).margin(6));

  const CameraRoute eights = builtInRoute("eights", {}).value();
  const std::vector<int> passes = passNumbers(eights);
  const auto half = static_cast<std::ptrdiff_t>(passes.size() / 2);
  const auto firsts = [](auto begin, auto end) {
    return static_cast<double>(std::count(begin, end, 1)) / static_cast<double>(end - begin);
  };
  CHECK(firsts(passes.begin(), passes.begin() + half) > 0.75);
  CHECK(firsts(passes.begin() + half, passes.end()) < 0.1);
}
