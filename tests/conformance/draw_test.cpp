// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/draw.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "config/check.hpp"
#include "conformance/lab.hpp"

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

Specimen specimen(const std::vector<std::string>& set = {}) {
  Specimen made;
  made.plugin.schema = schemaOf<Everything>();
  Settings settings = readSettings(made.plugin.schema, "everything", set);
  REQUIRE(settings.problems.empty());
  made.values = settings.values;
  made.set = settings.set;
  return made;
}

}  // namespace

TEST_CASE("every draw is legal: the host takes it when it is typed") {
  const Specimen all = specimen();
  for (int i = 0; i < 300; ++i) {
    const ParameterValues drawn = drawParameters(all, 1, i);
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
  const Specimen all = specimen();
  std::set<int> cells;
  std::set<Colour> colours;
  int small = 0;
  for (int i = 0; i < 300; ++i) {
    const auto bound = bindParameters<Everything>(drawParameters(all, 2, i));
    cells.insert(bound.value().cells);
    colours.insert(bound.value().colour);
    if (bound.value().decades < 1e-4) ++small;
  }
  CHECK(cells.contains(2));
  CHECK(cells.contains(64));
  CHECK(cells.size() > 20);
  CHECK(colours.size() == 3);
  CHECK(small > 20);  // even in size, not in value
}

TEST_CASE("a draw is its seed and number, and keeps what was given") {
  const Specimen all = specimen();
  CHECK(drawParameters(all, 3, 8) == drawParameters(all, 3, 8));
  CHECK(drawParameters(all, 3, 8) != drawParameters(all, 3, 9));
  CHECK(drawParameters(all, 3, 8) != drawParameters(all, 4, 8));
  const Specimen given = specimen({"cells=12", "share=0.25"});
  for (int i = 0; i < 50; ++i) {
    const auto bound = bindParameters<Everything>(drawParameters(given, 3, i));
    CHECK(bound.value().cells == 12);
    CHECK(bound.value().share == 0.25);
  }
}

TEST_CASE("a draw is told as a command line that repeats it") {
  const Specimen all = specimen();
  for (int i = 0; i < 20; ++i) {
    const ParameterValues drawn = drawParameters(all, 5, i);
    std::vector<std::string> words;
    std::istringstream text(difference(all.values, drawn));
    for (std::string word; text >> word;) {
      if (word != "--set") words.push_back(word);
    }
    const Settings typed = readSettings(all.plugin.schema, "everything", words);
    CHECK(typed.problems.empty());
    CHECK(typed.values == drawn);
  }
  CHECK(difference(all.values, all.values).empty());
}

TEST_CASE("required parameters that nobody gave are listed, wrong ones are problems") {
  Schema schema = schemaOf<Everything>();
  schema[0].required = true;
  const Settings nothing = readSettings(schema, "everything", {});
  CHECK(nothing.lacking == std::vector<std::string>{"flag"});
  CHECK(nothing.problems.empty());
  const Settings wrong = readSettings(schema, "everything", {"flag=true", "cells=65"});
  CHECK(wrong.lacking.empty());
  CHECK(wrong.problems.find("65 is out of range: 2 ... 64") != std::string::npos);
}
