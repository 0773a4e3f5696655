// SPDX-License-Identifier: BSD-3-Clause
// Saved cells: the round trip, and damage refused.
#include <catch2/catch.hpp>
#include <sstream>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

/// Laps of a ring road of 40 templates.
Decision lapFrame(BayesianAttractor& plugin, int frame) {
  const auto seen = frame < 40 ? novel(frame) : familiar(frame % 40, 0.01);
  return step(plugin, motionOf({4, 0.01 * (frame % 7), 2 * std::numbers::pi / 40}, frame), seen);
}

std::string stateAfter(BayesianAttractor& plugin, int frames) {
  for (int frame = 0; frame < frames; ++frame) lapFrame(plugin, frame);
  std::ostringstream stream;
  REQUIRE(plugin.save(stream).isOk());
  return stream.str();
}

Status loadText(BayesianAttractor& plugin, const std::string& text) {
  std::istringstream stream(text);
  return plugin.load(stream);
}

}  // namespace

TEST_CASE("a loaded instance decides as the saved one would, in the middle of a calibration") {
  BayesianAttractor saved;
  BayesianAttractor loaded;
  REQUIRE(configure(saved, {}).isOk());
  REQUIRE(configure(loaded, {}).isOk());
  REQUIRE(loadText(loaded, stateAfter(saved, 53)).isOk());
  int loops = 0;
  for (int frame = 53; frame < 140; ++frame) {
    const Decision a = lapFrame(saved, frame);
    const Decision b = lapFrame(loaded, frame);
    CHECK(a.action == b.action);
    CHECK(a.experience == b.experience);
    CHECK(a.heading == b.heading);
    CHECK(a.relative_yaw == b.relative_yaw);
    CHECK(a.confidence == b.confidence);
    loops += a.action == Action::CloseLoop ? 1 : 0;
  }
  CHECK(loops > 5);
  CHECK(arrayOf(saved, "grid.calibration") == arrayOf(loaded, "grid.calibration"));
}

TEST_CASE("what path integration knows is saved: measured views are judged alike after loading") {
  const auto frameOf = [](BayesianAttractor& plugin, int frame) {
    PlaceObservation seen = frame < 60 ? novel(frame) : familiar((frame * 7) % 60);
    if (frame >= 60 && frame % 3 == 0) seen = familiar(frame % 60);
    seen.has_relative_pose = frame >= 60;
    seen.covariance.diagonal().setConstant(0.01);
    Motion motion = motionOf({4, 0.02, 2 * std::numbers::pi / 60}, frame);
    motion.covariance.diagonal().setConstant(1e-4);
    return step(plugin, motion, seen);
  };
  BayesianAttractor saved;
  BayesianAttractor loaded;
  REQUIRE(configure(saved, {}).isOk());
  REQUIRE(configure(loaded, {}).isOk());
  for (int frame = 0; frame < 90; ++frame) frameOf(saved, frame);
  std::ostringstream stream;
  REQUIRE(saved.save(stream).isOk());
  REQUIRE(loadText(loaded, stream.str()).isOk());
  int loops = 0;
  for (int frame = 90; frame < 200; ++frame) {
    const Decision a = frameOf(saved, frame);
    const Decision b = frameOf(loaded, frame);
    CHECK(a.action == b.action);
    CHECK(a.experience == b.experience);
    CHECK(a.heading == b.heading);
    CHECK(arrayOf(saved, "grid.injected") == arrayOf(loaded, "grid.injected"));
    loops += a.action == Action::CloseLoop ? 1 : 0;
  }
  CHECK(loops > 10);
}

TEST_CASE("damaged and foreign states are refused, and the instance is as after reset") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  const std::string good = stateAfter(plugin, 60);
  for (std::size_t position = 0; position < good.size(); position += 97) {
    std::string bad = good;
    bad[position] = static_cast<char>(bad[position] ^ 0x04);
    CHECK(loadText(plugin, bad).code() == StatusCode::InvalidInput);
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, good.size() - 1}) {
    CHECK(loadText(plugin, good.substr(0, length)).code() == StatusCode::InvalidInput);
  }
  CHECK(lapFrame(plugin, 0).experience == 0);
}

TEST_CASE("a state from another manifold is refused") {
  BayesianAttractor saved;
  BayesianAttractor other;
  REQUIRE(configure(saved, {}).isOk());
  REQUIRE(configure(other, {{"period", 14.0}}).isOk());
  CHECK(loadText(other, stateAfter(saved, 5)).message() ==
        "the saved cells have another period, metres_per_cell or energy than configured");
}
