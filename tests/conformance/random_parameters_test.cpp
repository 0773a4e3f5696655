// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <set>

#include "config/values.hpp"
#include "conformance/check.hpp"

using namespace tolman;
using namespace tolman::conformance;

namespace {

enum class Colour : std::uint8_t { Red, Green, Blue };
constexpr std::array<std::string_view, 3> kColourNames = {"red", "green", "blue"};
constexpr std::span<const std::string_view> enumNames(Colour) { return kColourNames; }

struct Everything {
  bool flag = false;
  int cells = 36;
  int free = 7;
  double share = 0.5;
  double decades = 0.01;
  double open = 3;
  Colour colour = Colour::Green;
  std::string text = "as it is";
  std::vector<double> list = {1, 2, 3};
  static constexpr auto declaration() {
    using E = Everything;
    return parameters(
        parameter("flag", &E::flag).doc("."), parameter("cells", &E::cells).range(2, 64).doc("."),
        parameter("free", &E::free).doc("."), parameter("share", &E::share).range(0, 1).doc("."),
        parameter("decades", &E::decades).range(1e-6, 1).doc("."),
        parameter("open", &E::open).doc("."), parameter("colour", &E::colour).doc("."),
        parameter("text", &E::text).doc("."), parameter("list", &E::list).range(0, 9).doc("."));
  }
};

PluginUnderTest pluginUnderTest(const std::vector<std::string>& set = {}) {
  PluginUnderTest made;
  made.loaded.schema = schemaOf<Everything>();
  Settings settings = readSettings(made.loaded.schema, "everything", set);
  REQUIRE(settings.problems.empty());
  made.values = settings.values;
  made.set = settings.set;
  return made;
}

}  // namespace

TEST_CASE("every draw is legal for the host") {
  const PluginUnderTest all = pluginUnderTest();
  for (int i = 0; i < 300; ++i) {
    const ParameterValues drawn = randomParameters(all, 1, i);
    REQUIRE(drawn.size() == all.values.size());
    const auto bound = bindParameters<Everything>(drawn);
    REQUIRE(bound.isOk());
    const Everything& e = bound.value();
    CHECK((e.cells >= 2 && e.cells <= 64));
    CHECK((e.share >= 0 && e.share <= 1));
    CHECK((e.decades >= 1e-6 && e.decades <= 1));
    CHECK(e.text == "as it is");
    for (const double x : e.list) CHECK((x >= 0 && x <= 9));
  }
}

TEST_CASE("draws reach the ends of ranges, all choices and all decades") {
  const PluginUnderTest all = pluginUnderTest();
  std::set<int> cells;
  std::set<Colour> colours;
  int small = 0;
  for (int i = 0; i < 300; ++i) {
    const auto bound = bindParameters<Everything>(randomParameters(all, 2, i));
    cells.insert(bound.value().cells);
    colours.insert(bound.value().colour);
    if (bound.value().decades < 1e-4) ++small;
  }
  CHECK(cells.contains(2));
  CHECK(cells.contains(64));
  CHECK(cells.size() > 20);
  CHECK(colours.size() == 3);
  CHECK(small > 20);  // sampled logarithmically
}

TEST_CASE("seed and number determine a draw; values of --set stay") {
  const PluginUnderTest all = pluginUnderTest();
  CHECK(randomParameters(all, 3, 8) == randomParameters(all, 3, 8));
  CHECK(randomParameters(all, 3, 8) != randomParameters(all, 3, 9));
  CHECK(randomParameters(all, 3, 8) != randomParameters(all, 4, 8));
  const PluginUnderTest given = pluginUnderTest({"cells=12", "share=0.25"});
  for (int i = 0; i < 50; ++i) {
    const auto bound = bindParameters<Everything>(randomParameters(given, 3, i));
    CHECK(bound.value().cells == 12);
    CHECK(bound.value().share == 0.25);
  }
}

TEST_CASE("difference() gives the options that repeat a draw") {
  const PluginUnderTest all = pluginUnderTest();
  for (int i = 0; i < 20; ++i) {
    const ParameterValues drawn = randomParameters(all, 5, i);
    std::vector<std::string> words;
    std::istringstream text(difference(all.values, drawn));
    for (std::string word; text >> word;) {
      if (word != "--set") words.push_back(word);
    }
    const Settings typed = readSettings(all.loaded.schema, "everything", words);
    CHECK(typed.problems.empty());
    CHECK(typed.values == drawn);
  }
  CHECK(difference(all.values, all.values).empty());
}

TEST_CASE("missing required parameters are listed, illegal values are problems") {
  Schema schema = schemaOf<Everything>();
  schema[0].required = true;
  const Settings nothing = readSettings(schema, "everything", {});
  CHECK(nothing.missing == std::vector<std::string>{"flag"});
  CHECK(nothing.problems.empty());
  const Settings wrong = readSettings(schema, "everything", {"flag=true", "cells=65"});
  CHECK(wrong.missing.empty());
  CHECK(wrong.problems.find("65 is out of range: 2 ... 64") != std::string::npos);
}
