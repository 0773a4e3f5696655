// SPDX-License-Identifier: BSD-3-Clause
// The grammar of conditions, refused texts, and the frames of an entry.
#include "conditions.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman;
using namespace tolman::town;

namespace {

std::string refusal(const std::string& text) {
  const auto entries = parseConditions(text);
  REQUIRE_FALSE(entries.isOk());
  return std::string(entries.status().message());
}

std::vector<Condition> conditionsOn(const CameraRoute& route, const std::string& text) {
  std::vector<std::string> warnings;
  return conditionsOf(route, parseConditions(text).value(), warnings);
}

std::vector<std::string> warningsOn(const CameraRoute& route, const std::string& text) {
  std::vector<std::string> warnings;
  conditionsOf(route, parseConditions(text).value(), warnings);
  return warnings;
}

}  // namespace

TEST_CASE("entries have a range and words") {
  CHECK(parseConditions("").value().empty());
  CHECK(parseConditions(" ; ").value().empty());
  const auto entries = parseConditions("pass 2-3 = night  rain; 300-450.5 m=dusk ;all = snow");
  REQUIRE(entries.isOk());
  REQUIRE(entries.value().size() == 3);
  const ConditionEntry& pass = entries.value()[0];
  CHECK(pass.is_pass);
  CHECK(pass.first == 2);
  CHECK(pass.last == 3);
  CHECK(pass.words == std::vector<std::string>{"night", "rain"});
  const ConditionEntry& metres = entries.value()[1];
  CHECK_FALSE(metres.is_pass);
  CHECK(metres.first == 300);
  CHECK(metres.last == 450.5);
  CHECK(std::isinf(entries.value()[2].last));
}

TEST_CASE("what is not in the grammar is refused by name") {
  const std::string range = "does not begin with a range";
  for (const char* text :
       {"night", "pass = night", "pass 0 = night", "pass 3-2 = night", "pass 1.5 = night",
        "pass x = night", "5 m = night", "9-5 m = night", "1-2 km = night", "= night",
        "pass 1 2 = night", "-5-9 m = night", "nan-9 m = night", "1e99-2e99 m = night"}) {
    INFO(text);
    CHECK(refusal(text).find(range) != std::string::npos);
    CHECK(refusal(text).find(text) != std::string::npos);
  }
  CHECK(refusal("pass 1 =").find("says nothing") != std::string::npos);
  CHECK(refusal("all = rain; all = wet") ==
        "conditions: 'all = wet': 'wet' is no condition; use day, dusk, night, clear, overcast, "
        "fog, rain, snow, bare, leaf, exchanged");
  CHECK(refusal("all = day snow night") ==
        "conditions: 'all = day snow night': 'day' and 'night' exclude each other");
  CHECK(refusal("all = fog rain").find("'fog' and 'rain' exclude") != std::string::npos);
  CHECK(refusal("9-5 m = night").find("the smaller number first") != std::string::npos);
}

TEST_CASE("entries that hold at no frame are told") {
  const CameraRoute route = builtInRoute("block", {}).value();
  CHECK(warningsOn(route, "all = rain; pass 2 = night; 0-20 m = snow").empty());
  CHECK(warningsOn(route, "pass 2-3 = day; pass 3-9 = night") ==
        std::vector<std::string>{"conditions: 'pass 3-9 = night' holds at no frame: the route is "
                                 "driven at most 2 times at one place"});
  const std::string metres = std::to_string(std::lround(drivenMetres(route).back()));
  CHECK(warningsOn(route, "90000-90010 m = night").front() ==
        "conditions: '90000-90010 m = night' holds at no frame: the route is " + metres +
            " m long");
}

TEST_CASE("metres hold where they are driven, later entries win") {
  const CameraRoute route = builtInRoute("block", {}).value();
  const std::vector<double> driven = drivenMetres(route);
  const auto conditions = conditionsOn(route, "all = night snow; 50-100 m = day rain");
  REQUIRE(conditions.size() == route.T_town_camera.size());
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const bool inside = driven[i] >= 50 && driven[i] <= 100;
    CHECK(conditions[i].is_night != inside);
    CHECK(conditions[i].rains == inside);
    CHECK(conditions[i].snow);
    CHECK(conditions[i].weather.has_value() == inside);
  }
  for (const Condition& condition : conditionsOn(route, "")) CHECK(condition == Condition{});
}

TEST_CASE("passes count how often a street was driven") {
  // block: 30 m over its start. eights: everything twice; crossings at a right angle do not count.
  const CameraRoute block = builtInRoute("block", {}).value();
  const std::vector<int> once = passNumbers(block);
  const std::vector<double> driven = drivenMetres(block);
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
  for (const Condition& c : conditionsOn(eights, "pass 1-9 = night")) CHECK(c.is_night);
}
