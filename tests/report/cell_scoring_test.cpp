// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/cell_scoring.hpp"

#include "report/recorded_walk.hpp"

using namespace tolman;
using test::kFrames;
using test::kTurn;

namespace {

evaluation::CellFigures scored(const test::Described& described, const test::Errors& errors = {}) {
  const auto cells = test::readWalk(described, errors).metrics.cells;
  REQUIRE(cells);
  return *cells;
}

}  // namespace

TEST_CASE("right cells have no error, in whatever frame the truth is, and score above chance") {
  const auto cells = scored({});
  CHECK(cells.truth);
  REQUIRE(cells.rings.size() == 1);
  REQUIRE(cells.sheets.size() == 2);
  REQUIRE((cells.rings[0].error_deg && cells.position_m));
  CHECK(cells.rings[0].error_deg->count == kFrames);
  CHECK(cells.rings[0].error_deg->p90 < 0.1);
  CHECK(cells.position_m->p90 < 0.05);
  CHECK(cells.modulo_m == 0);
  CHECK(cells.least_shift_s == Approx(6).epsilon(0.01));  // a tenth of 60 s
  REQUIRE((cells.rings[0].scores.mean_vector_length && cells.sheets[0].scores.square));
  CHECK(cells.rings[0].scores.mean_vector_length->share_better == 1);
  CHECK(cells.sheets[0].scores.square->share_better > 0.8);
  CHECK(cells.sheets[0].units == 144);
}

TEST_CASE("errors are those of ring and modules, also beyond half a period") {
  const auto cells = scored({}, {-kTurn / 4, {15, 8}});
  REQUIRE((cells.rings[0].error_deg && cells.position_m));
  CHECK(cells.rings[0].error_deg->median == Approx(90).margin(0.1));
  CHECK(cells.position_m->median == Approx(17).margin(0.1));
}

TEST_CASE("a single module tells the position modulo its period") {
  const auto cells = scored({{20}}, {0, {23, -20}});
  REQUIRE(cells.position_m);
  CHECK(cells.position_m->median == Approx(3).margin(0.1));
  CHECK(cells.modulo_m == 20);
}

TEST_CASE(
    "without truth there are no errors, and the reason is said; units are scored on the map") {
  const auto cells = scored({{20, 28.4}, "m", false});
  CHECK_FALSE(cells.truth);
  CHECK_FALSE(cells.position_m);
  CHECK_FALSE(cells.rings[0].error_deg);
  CHECK(cells.rings[0].scores.mean_vector_length);
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
