// SPDX-License-Identifier: BSD-3-Clause
// Saved cells: the round trip, and damage refused.
#include <catch2/catch.hpp>
#include <numbers>
#include <sstream>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

/// Laps of a ring road of 60 templates, with look-alikes, carried away in the second lap.
Decision lapFrame(BayesianAttractor& plugin, int frame) {
  PlaceObservation seen = frame < 60 ? novel(frame) : measured((frame * 7) % 60);
  if (frame >= 60 && frame % 3 == 0) seen = measured(frame % 60);
  Motion motion = motionOf({4, 0.02, 2 * std::numbers::pi / 60}, frame);
  if (frame == 85) motion.state = TrackingState::Initialising;
  return step(plugin, motion, seen);
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

TEST_CASE("a loaded instance decides as the saved one would, among open hypotheses") {
  const int frames = GENERATE(75, 90);  // known where, and carried away
  BayesianAttractor saved;
  BayesianAttractor loaded;
  REQUIRE(configure(saved, {}).isOk());
  REQUIRE(configure(loaded, {}).isOk());
  REQUIRE(loadText(loaded, stateAfter(saved, frames)).isOk());
  CHECK(arrayOf(saved, "hypotheses") == arrayOf(loaded, "hypotheses"));
  int loops = 0;
  for (int frame = frames; frame < 250; ++frame) {
    const Decision a = lapFrame(saved, frame);
    const Decision b = lapFrame(loaded, frame);
    CHECK(a.action == b.action);
    CHECK(a.experience == b.experience);
    CHECK(a.heading == b.heading);
    CHECK(a.confidence == b.confidence);
    CHECK(a.T_experience_current.matrix() == b.T_experience_current.matrix());
    REQUIRE(a.earlier.size() == b.earlier.size());
    for (std::size_t i = 0; i < a.earlier.size(); ++i) {
      CHECK(a.earlier[i].frame == b.earlier[i].frame);
      CHECK(a.earlier[i].experience == b.earlier[i].experience);
      CHECK(a.earlier[i].covariance == b.earlier[i].covariance);
    }
    loops += a.action == Action::CloseLoop ? 1 : 0;
  }
  CHECK(loops > 5);
}

TEST_CASE("damaged and foreign states are refused, and the instance is as after reset") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  const std::string good = stateAfter(plugin, 70);
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

TEST_CASE("a state of other grid modules is refused") {
  BayesianAttractor saved;
  BayesianAttractor other;
  REQUIRE(configure(saved, {}).isOk());
  REQUIRE(configure(other, {{"period", 140.0}}).isOk());
  CHECK(loadText(other, stateAfter(saved, 5)).message() ==
        "the saved cells have another period or number of modules");
}
