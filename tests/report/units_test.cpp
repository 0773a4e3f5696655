// SPDX-License-Identifier: BSD-3-Clause
// Numbers of units and cells in neurons.json and metrics.json.
#include <fmt/format.h>

#include "evaluation/metrics.hpp"
#include "report/figures.hpp"
#include "report/recorded_walk.hpp"

using namespace tolman::report;
using namespace tolman;

namespace {

evaluation::CellFigures scored(const test::Described& described, double heading_error = 0) {
  const auto cells = test::readWalk(described, heading_error).metrics.cells;
  REQUIRE(cells);
  return *cells;
}

}  // namespace

TEST_CASE("all units of the ring: angles are degrees, the half width is about 45") {
  const auto json = neuronsJson(test::readWalk({}));
  REQUIRE(json["head_direction"].size() == 24);
  for (const auto& unit : json["head_direction"]) {
    CHECK(unit["half_width_deg"].get<double>() == Approx(45).margin(3));
    CHECK(unit["mean_vector_length"].get<double>() == Approx(0.74).margin(0.05));
    const double off = unit["preferred_deg"].get<double>() - unit["nominal_deg"].get<double>();
    CHECK(std::remainder(off, 360) == Approx(0).margin(3));
    CHECK(unit["tuning"].size() == 36);
  }
  CHECK(json["head_direction"][3]["unit"] == 4);
  CHECK(json["head_direction"][3]["nominal_deg"].get<double>() == Approx(45));
}

TEST_CASE("all units of all modules, in rows of the sheet; units count from one") {
  const RunData run = test::readWalk({});
  const auto json = neuronsJson(run);
  REQUIRE(json["grid"].size() == 2 * 144);
  CHECK(json["grid"][0]["array"] == "grid0.activity");
  CHECK(json["grid"][14]["unit"] == nlohmann::json({2, 3}));
  const auto& second = json["grid"][144 + 14];
  CHECK(second["array"] == "grid1.activity");
  CHECK(second["unit"] == nlohmann::json({2, 3}));
  CHECK(second["nominal"][1].get<double>() == Approx(2 * 28.4 / 12));
  const auto& scores = run.metrics.cells->sheets[1].scores;
  for (const char* key : {"grid_score_square", "spatial_information_bits"}) {
    CHECK(second[key] == scores.units[14].scores[scores.indexOf(key)].value());
  }
  CHECK(json["grid"][0]["spacing_m"].get<double>() == Approx(20).margin(4));
  CHECK(json["places"] == "truth");
}

TEST_CASE("a run without described activity has no neurons") {
  CHECK(neuronsJson(test::readWalk({{20}, "m", true, false})).is_null());
}

TEST_CASE("the first units are drawn, of the ring with its opposite") {
  const RunData run = test::readWalk({{24}});
  const auto units = drawnUnits(run);
  REQUIRE(units.size() == 3);
  CHECK(units[0].name == "head direction unit 1 of 24, 0 deg");
  CHECK(units[1].name == "head direction unit 13 of 24, 180 deg");
  CHECK(units[2].name == "grid unit (1, 1), phase (0, 0) m");
  const auto& tuning = run.metrics.cells->rings[0].scores.units[0].tuning;
  CHECK(units[0].measures ==
        fmt::format("mean vector length {:.2f} towards {:.0f} deg, half width {:.0f} deg",
                    tuning.mean_vector_length, tuning.preferred * evaluation::kDegrees,
                    *tuning.half_width * evaluation::kDegrees));
  CHECK(drawnUnits({}).empty());
}

using test::kFrames;
using test::kTurn;

TEST_CASE("right cells have no error, in whatever frame the truth is, and score above chance") {
  const auto cells = scored({});
  CHECK(cells.truth);
  REQUIRE(cells.rings.size() == 1);
  REQUIRE(cells.sheets.size() == 2);
  CHECK(cells.rings[0].error_deg.count == kFrames);
  CHECK(cells.rings[0].error_deg.p90 < 0.1);
  CHECK(cells.least_shift_s == Approx(6).epsilon(0.01));  // a tenth of 60 s
  REQUIRE((cells.rings[0].scores.of("mean_vector_length") &&
           cells.sheets[0].scores.of("grid_score_square")));
  CHECK(cells.rings[0].scores.of("mean_vector_length")->share_better == 1);
  CHECK(cells.sheets[0].scores.of("grid_score_square")->share_better > 0.8);
  CHECK(cells.sheets[0].units == 144);
}

TEST_CASE("the error of a ring is that of its population vector") {
  const auto cells = scored({}, -kTurn / 4);
  REQUIRE(cells.rings[0].error_deg.count > 0);
  CHECK(cells.rings[0].error_deg.median == Approx(90).margin(0.1));
}

TEST_CASE(
    "without truth there are no errors, and the reason is said; units are scored on the map") {
  const auto cells = scored({{20, 28.4}, "m", false});
  CHECK_FALSE(cells.truth);
  CHECK(cells.rings[0].error_deg.count == 0);
  CHECK(cells.rings[0].scores.of("mean_vector_length"));
  const auto json = toJson(cells);
  CHECK(json["reason"] == "there is no ground truth");
  CHECK(json["places"] == "map");
  CHECK(json["head_direction"][0]["error"]["median_deg"].is_null());
  CHECK(json["head_direction"][0]["mean_vector_length"]["median"].is_number());
}

TEST_CASE("a run without described activity has no cells") {
  CHECK_FALSE(test::readWalk({{20}, "m", true, false}).metrics.cells);
}
