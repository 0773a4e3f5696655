// SPDX-License-Identifier: BSD-3-Clause
// A map must not degrade odometry that is more accurate than its loops: a real street that is
// driven forwards and backwards twice, so that every pass revisits places.
#include <catch2/catch.hpp>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;

TEST_CASE("the map of a street driven up and down is as good as its odometry", "[data]") {
  const std::string config = GENERATE("kitti.yaml", "features.yaml");
  const auto clip = dataOrSkip("kitti_clips/06");
  if (!clip) return;
  const TemporaryFolder out;
  const Finished finished = tolman::test::tolman(
      {"run", inSource("configs/") + config, "--set", "source.path=" + clip->string(), "--set",
       "source.order=pingpong", "--set", "source.passes=4", "--set", "record.arrays_every=0",
       "--out", (out.path() / "run").string(), "--quiet"});
  INFO(config << " " << finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto metrics = readJson(out.path() / "run/metrics.json");
  const double odometry = metrics["odometry"]["ate"]["rmse_m"].get<double>();
  const double map = metrics["map"]["ate"]["rmse_m"].get<double>();
  CHECK(metrics["loop_links"].get<int>() > 3);
  CHECK(map <= 1.1 * odometry);
  WARN(config << ": ATE of odometry " << odometry << " m, of the map " << map << " m");
}
