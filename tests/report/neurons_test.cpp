// SPDX-License-Identifier: BSD-3-Clause
// Measures of units whose firing is known.
#include "report/neurons.hpp"

#include <fmt/format.h>

#include "report/recorded_walk.hpp"

using namespace tolman;
using namespace tolman::report;

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
  const evaluation::SheetUnit& unit = run.metrics.cells->sheets[1].scores.units[14];
  REQUIRE(unit.scores);
  CHECK(second["grid_score_square"] == unit.scores->square);
  CHECK(second["spatial_information_bits"] == unit.information_bits);
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
