// SPDX-License-Identifier: BSD-3-Clause
#include "app/summary.hpp"

#include <catch2/catch.hpp>

using namespace tolman;

TEST_CASE("health comes first, in one block") {
  engine::Outcome outcome;
  outcome.counters.frames = 50;
  outcome.counters.initialising = 1;
  outcome.counters.lost = 3;
  outcome.counters.dropped = 2;
  outcome.counters.skipped = 1;
  outcome.counters.templates = 7;
  outcome.counters.loop_decisions = 3;
  outcome.counters.links = 20;
  outcome.counters.loop_links = 1;
  outcome.wall_s = 5;
  outcome.finish_times_ns[static_cast<std::size_t>(Role::Map)] = 1'250'000'000;
  CHECK(app::healthText(outcome) ==
        "tracking  46 of 50 frames, 1 initialising, 3 lost\n"
        "frames    50 processed, 2 dropped, 1 skipped, 0 without image\n"
        "memory    7 templates, 0 experiences, 20 links, of them 1 loop link (3 loop decisions)\n"
        "time      5.0 s, 10.0 frames/s; final optimisation of the map 1.3 s\n");
}

TEST_CASE("a realtime run tells how old its poses are") {
  engine::Outcome outcome;
  outcome.counters.frames = 50;
  CHECK_THAT(app::healthText(outcome), !Catch::Contains("latency"));
  outcome.latency = {50, 12.34, 45.67};
  CHECK_THAT(app::healthText(outcome),
             Catch::EndsWith("latency   image to pose median 12.3 ms, 99 % 45.7 ms\n"));
}

TEST_CASE("that a run never tracked is its first line") {
  engine::Outcome outcome;
  outcome.counters.frames = 50;
  outcome.counters.initialising = 47;
  outcome.counters.lost = 3;
  outcome.counters.lost_at_end = true;
  CHECK_THAT(
      app::healthText(outcome),
      Catch::StartsWith("tracking  0 of 50 frames, 47 initialising, 3 lost; lost at the end\n"
                        "          no motion in the whole run; are the images rectified"));
}

TEST_CASE("a run of one frame found no motion either, and is not told to look at its images") {
  engine::Outcome outcome;
  outcome.counters.frames = 1;
  outcome.counters.initialising = 1;
  CHECK_THAT(app::healthText(outcome),
             Catch::StartsWith("tracking  0 of 1 frames, 1 initialising, 0 lost\n"
                               "          no motion in the whole run: it has one frame, and motion "
                               "is found between two; take more\n"));
  outcome.counters.frames = 0;  // nothing was processed: the failure says why
  outcome.counters.initialising = 0;
  CHECK_FALSE(outcome.counters.neverTracked());
}

TEST_CASE("figures name their alignment, coverage and segments") {
  evaluation::TrajectoryMetrics scored;
  scored.path_length_m = 60.1;
  scored.poses = scored.matched = 51;
  scored.scores.emplace();
  scored.scores->ate_m.rmse = 0.1234;
  scored.scores->coverage = 0.5;
  scored.scores->kitti.segments = 20;
  scored.scores->kitti.lengths.name = "short";
  scored.scores->kitti.t_rel_percent = 1.5;
  CHECK(app::trajectoryText("odometry", scored) ==
        "odometry  path 60.10 m over 51 poses; 51 with truth; coverage 50.0 %\n"
        "          ATE rmse 0.123 m  (mean 0.000, median 0.000, min 0.000, max 0.000)\n"
        "          drift 1.500 %, 0.000 deg/100 m  (20 segments, short lengths)\n");
  scored.scores->vertical_m.count = 51;
  scored.scores->vertical_m.rmse = 0.04;
  scored.scores->horizontal_m.rmse = 0.1167;
  CHECK(app::trajectoryText("odometry", scored)
            .find("horizontal rmse 0.117 m, vertical rmse 0.040 m\n") != std::string::npos);
  scored.scores->vertical_m = scored.scores->horizontal_m = {};
  scored.scores->no_horizontal = "the path is straight";
  CHECK_THAT(app::trajectoryText("odometry", scored),
             Catch::Contains("\n          horizontal and vertical error: the path is straight\n"));
}

TEST_CASE("without truth there are no error figures, and the reason is said") {
  evaluation::TrajectoryMetrics unscored;
  unscored.path_length_m = 108;
  unscored.poses = 108;
  unscored.reason = "there is no ground truth";
  CHECK(app::trajectoryText("map", unscored) ==
        "map       path 108.00 m over 108 poses; no error figures: there is no ground truth\n");
  unscored.in_metres = false;
  CHECK_THAT(app::trajectoryText("map", unscored),
             Catch::Contains("path 108.00 units of unknown scale over 108 poses"));
  const auto json = evaluation::toJson(unscored);
  CHECK(json["path_length_m"].is_null());
  CHECK(json["path_length_units"] == 108);
}

TEST_CASE("one line states how far the cells were off") {
  evaluation::CellFigures cells;
  cells.reason = "there is no ground truth";
  CHECK(app::cellsText(cells) == "cells     no errors: there is no ground truth\n");
  cells.reason.clear();
  CHECK(app::cellsText(cells).empty());
  cells.rings.resize(1);
  cells.rings[0].error_deg = {.count = 100, .median = 3.62, .p90 = 7.04};
  CHECK(app::cellsText(cells) == "cells     heading error median 3.6, 90 % 7.0 deg\n");
}
