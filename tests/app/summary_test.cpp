// SPDX-License-Identifier: BSD-3-Clause
#include "app/summary.hpp"

#include <catch2/catch.hpp>

using namespace tolman;

TEST_CASE("health comes first, in one block") {
  pipeline::Outcome outcome;
  outcome.counters.frames = 50;
  outcome.counters.dropped = 2;
  outcome.counters.skipped = 1;
  outcome.counters.templates = 7;
  outcome.counters.loops = 3;
  outcome.finish_times_ns[static_cast<std::size_t>(Role::Map)] = 1'250'000'000;
  CHECK(app::healthText(outcome, 5.0) ==
        "frames    50 processed, 2 dropped, 1 skipped, 0 without image, 0 lost\n"
        "memory    7 templates, 0 experiences, 0 links, 3 loops\n"
        "time      5.0 s, 10.0 frames/s; the map's last work 1.25 s\n");
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
        "odometry  path 60.10 m over 51 poses; matched 51 (50.0 % of the truth)\n"
        "          ATE rmse 0.123 m  (mean 0.000, median 0.000, min 0.000, max 0.000)\n"
        "          drift 1.500 %, 0.000 deg/100 m  (20 segments, short lengths)\n");
}

TEST_CASE("without truth there are no error figures, and the reason is said") {
  evaluation::TrajectoryMetrics unscored;
  unscored.path_length_m = 108;
  unscored.poses = 108;
  unscored.reason = "there is no ground truth";
  CHECK(app::trajectoryText("map", unscored) ==
        "map       path 108.00 m over 108 poses; no error figures: there is no ground truth\n");
}
