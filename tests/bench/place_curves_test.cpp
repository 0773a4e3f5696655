// SPDX-License-Identifier: BSD-3-Clause
// Curves from files, and their positions in the figure.
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>

#include "experiment/bench.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::experiment;

namespace {

Result<PlaceCurve> curveOfText(const std::string& text) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "curve.json";
  std::ofstream(file) << text;
  return placeCurveOf(file);
}

struct Polyline {
  std::string colour;
  std::vector<std::pair<double, double>> points;  ///< px
};

std::vector<Polyline> polylinesOf(const std::string& svg) {
  const std::regex line("<polyline fill=\"none\" stroke=\"([^\"]+)\"[^>]* points=\"([^\"]*)\"/>");
  const std::regex point("([0-9.-]+),([0-9.-]+) ");
  std::vector<Polyline> lines;
  for (std::sregex_iterator i(svg.begin(), svg.end(), line), end; i != end; ++i) {
    const std::string points = (*i)[2];
    Polyline found{(*i)[1], {}};
    for (std::sregex_iterator p(points.begin(), points.end(), point); p != end; ++p) {
      found.points.emplace_back(std::stod((*p)[1]), std::stod((*p)[2]));
    }
    lines.push_back(std::move(found));
  }
  return lines;
}

}  // namespace

TEST_CASE("the curve of a file is that of the measurement") {
  const auto curve = curveOfText(
      R"({"name": "night", "plugin": "x", "rows": [{"precision": 1, "recall": 0.25, "score": 3},
          {"precision": 0.5, "recall": 0.5}]})");
  REQUIRE(curve.isOk());
  CHECK(curve.value().name == "night");
  REQUIRE(curve.value().points.size() == 2);
  CHECK(curve.value().points[0].precision == 1);
  CHECK(curve.value().points[0].recall == 0.25);
  CHECK(curve.value().points[1].precision == 0.5);
  CHECK(curve.value().points[1].recall == 0.5);
  CHECK(curveOfText(R"({"name": "none", "rows": []})").value().points.empty());
}

TEST_CASE("files that are no measurement are refused by name") {
  for (const char* text :
       {"", "{", "[]", "3", R"({"name": "a"})", R"({"rows": []})", R"({"name": 1, "rows": []})",
        R"({"name": "a", "rows": {}})", R"({"name": "a", "rows": [1]})",
        R"({"name": "a", "rows": [{"precision": 1}]})",
        R"({"name": "a", "rows": [{"precision": "1", "recall": 0}]})",
        R"({"name": "a", "rows": [{"precision": 1.01, "recall": 0}]})",
        R"({"name": "a", "rows": [{"precision": 1, "recall": -1e300}]})"}) {
    const auto curve = curveOfText(text);
    CAPTURE(text);
    REQUIRE_FALSE(curve.isOk());
    CHECK(curve.status().code() == StatusCode::InvalidInput);
    CHECK(curve.status().message().ends_with(
        "curve.json: is not what `tolman bench places --json` prints"));
  }
  CHECK(placeCurveOf("/absent.json").status().message().starts_with("/absent.json: is missing"));
  CHECK_FALSE(placeCurveOf("/").isOk());
}

TEST_CASE("the figure has each curve at its recalls and precisions, in a colour of its own") {
  const std::string svg =
      placeCurvesFigure({{"first & best", {{0.1, 1, 1, 0.2}, {0.2, 2, 0.75, 1}}},
                         {"second", {{0.1, 1, 0, 0}, {0.2, 2, 0.5, 0.5}, {0.3, 3, 0.5, 0.6}}}});
  const auto lines = polylinesOf(svg);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].colour != lines[1].colour);
  REQUIRE(lines[0].points.size() == 2);
  REQUIRE(lines[1].points.size() == 3);
  // Two points give the scales; the others must agree.
  const auto& origin = lines[1].points[0];
  const double per_recall = lines[0].points[1].first - origin.first;
  const double per_precision = lines[0].points[0].second - origin.second;
  CHECK(per_recall > 300);
  CHECK(per_precision < -300);  // upwards
  CHECK(lines[0].points[0].first == Approx(origin.first + 0.2 * per_recall).margin(0.1));
  CHECK(lines[0].points[1].second == Approx(origin.second + 0.75 * per_precision).margin(0.1));
  CHECK(lines[1].points[2].first == Approx(origin.first + 0.6 * per_recall).margin(0.1));
  CHECK(lines[1].points[2].second == Approx(origin.second + 0.5 * per_precision).margin(0.1));
  for (const char* text : {">first &amp; best<", ">second<", ">recall<", ">precision<"}) {
    CAPTURE(text);
    CHECK(svg.find(text) != std::string::npos);
  }
}

TEST_CASE("a figure without curves, and one with many, is a figure") {
  CHECK(polylinesOf(placeCurvesFigure({})).empty());
  const std::vector<PlaceCurve> many(20, {"again", {{0, 1, 1, 0.1}, {1, 2, 0.5, 0.2}}});
  CHECK(polylinesOf(placeCurvesFigure(many)).size() == 20);
}
