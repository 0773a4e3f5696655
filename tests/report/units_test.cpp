// SPDX-License-Identifier: BSD-3-Clause
// Numbers of units and cells in neurons.json and metrics.json.
#include <fmt/format.h>

#include "evaluation/metrics.hpp"
#include "report/figures.hpp"
#include "report/recorded_walk.hpp"

using namespace tolman::report;
using namespace tolman;

namespace {

evaluation::CellFigures scored(const test::Described& described, const test::Errors& errors = {}) {
  const auto cells = test::readWalk(described, errors).metrics.cells;
  REQUIRE(cells);
  return *cells;
}

}  // namespace

TEST_CASE("all units of the ring: angles are degrees, the half width is about 45") {
  const auto json = neuronsJson(test::readWalk({}), {});
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
  const auto json = neuronsJson(run, {});
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
  CHECK(neuronsJson(test::readWalk({{20}, "m", true, false}), {}).is_null());
}

TEST_CASE("a rate map has null where nobody was") {
  const auto json = toJson(evaluation::rateMap({{{0, 0}, 0, 2}, {{10, 0}, 0, 4}}, 10));
  CHECK(json["rate"].size() == 11);
  CHECK(json["rate"][0][0] == 2);
  CHECK(json["rate"][5][0].is_null());
  CHECK(json["rate"][10][0] == 4);
  CHECK(json["bin_m"] == 1);
}

TEST_CASE("a chosen unit is drawn, of the ring with its opposite") {
  const RunData run = test::readWalk({{24}});
  const auto units = drawnUnits(run, {9, 1, 0});
  REQUIRE(units.isOk());
  REQUIRE(units.value().size() == 3);
  CHECK(units.value()[0].name == "head direction unit 10 of 24, 135 deg");
  CHECK(units.value()[1].name == "head direction unit 22 of 24, 315 deg");
  CHECK(units.value()[2].name == "grid unit (2, 1), phase (2, 0) m");
  const auto json = neuronsJson(run, units.value());
  CHECK(json["rate_maps"].contains("grid unit (2, 1), phase (2, 0) m"));
  const auto& tuning = run.metrics.cells->rings[0].scores.units[9].tuning;
  CHECK(units.value()[0].measures ==
        fmt::format("mean vector length {:.2f} towards {:.0f} deg, half width {:.0f} deg",
                    tuning.mean_vector_length, tuning.preferred * evaluation::kDegrees,
                    *tuning.half_width * evaluation::kDegrees));
}

TEST_CASE("a unit that the run does not have is refused") {
  const RunData run = test::readWalk({{20}});
  CHECK(drawnUnits(run, {24, 0, 0}).status().message() ==
        "there is no head direction unit 25: this run has 24");
  CHECK(drawnUnits(run, {0, 0, 12}).status().message() ==
        "there is no grid unit 1,13: this run has 12 by 12");
  CHECK(drawnUnits({}, {0, 1, 0}).status().code() == StatusCode::InvalidParameter);
  CHECK(drawnUnits({}, {}).value().empty());
}

using test::kFrames;
using test::kTurn;

TEST_CASE("right cells have no error, in whatever frame the truth is, and score above chance") {
  const auto cells = scored({});
  CHECK(cells.truth);
  REQUIRE(cells.rings.size() == 1);
  REQUIRE(cells.sheets.size() == 2);
  REQUIRE((cells.rings[0].error_deg.count > 0 && cells.position_m.count > 0));
  CHECK(cells.rings[0].error_deg.count == kFrames);
  CHECK(cells.rings[0].error_deg.p90 < 0.1);
  CHECK(cells.position_m.p90 < 0.05);
  CHECK(cells.modulo_m == 0);
  CHECK(cells.least_shift_s == Approx(6).epsilon(0.01));  // a tenth of 60 s
  REQUIRE((cells.rings[0].scores.of("mean_vector_length") &&
           cells.sheets[0].scores.of("grid_score_square")));
  CHECK(cells.rings[0].scores.of("mean_vector_length")->share_better == 1);
  CHECK(cells.sheets[0].scores.of("grid_score_square")->share_better > 0.8);
  CHECK(cells.sheets[0].units == 144);
}

TEST_CASE("errors are those of ring and modules, also beyond half a period") {
  const auto cells = scored({}, {-kTurn / 4, {15, 8}});
  REQUIRE((cells.rings[0].error_deg.count > 0 && cells.position_m.count > 0));
  CHECK(cells.rings[0].error_deg.median == Approx(90).margin(0.1));
  CHECK(cells.position_m.median == Approx(17).margin(0.1));
}

TEST_CASE("a single module tells the position modulo its period") {
  const auto cells = scored({{20}}, {0, {23, -20}});
  REQUIRE(cells.position_m.count > 0);
  CHECK(cells.position_m.median == Approx(3).margin(0.1));
  CHECK(cells.modulo_m == 20);
}

TEST_CASE(
    "without truth there are no errors, and the reason is said; units are scored on the map") {
  const auto cells = scored({{20, 28.4}, "m", false});
  CHECK_FALSE(cells.truth);
  CHECK(cells.position_m.count == 0);
  CHECK(cells.rings[0].error_deg.count == 0);
  CHECK(cells.rings[0].scores.of("mean_vector_length"));
  const auto json = toJson(cells);
  CHECK(json["reason"] == "there is no ground truth");
  CHECK(json["places"] == "map");
  CHECK(json["head_direction"][0]["error"]["median_deg"].is_null());
  CHECK(json["position_error"]["median_m"].is_null());
  CHECK(json["head_direction"][0]["mean_vector_length"]["median"].is_number());
}

TEST_CASE("modules whose axes are not metres tell no position, and the reason is said") {
  const auto json = toJson(scored({{20}, "cells"}));
  CHECK(json["position_error"]["median_m"].is_null());
  CHECK(json["position_error"]["reason"] == "the axes of grid0.activity are in cells, not in m");
  CHECK(json["head_direction"][0]["error"]["median_deg"].is_number());
  CHECK(json["grid"][0]["grid_score_square"]["median"].is_number());
}

TEST_CASE("a run without described activity has no cells") {
  CHECK_FALSE(test::readWalk({{20}, "m", true, false}).metrics.cells);
}
