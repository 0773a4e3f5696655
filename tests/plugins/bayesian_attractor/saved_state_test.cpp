// SPDX-License-Identifier: BSD-3-Clause
// Saved states with a valid envelope and wrong numbers: refused, or used without failure.
#include "saved_state.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <numbers>

#include "harness.hpp"
#include "support/saved_payload.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

Motion ringStep(int frame) { return motionOf({4, 0, 2 * std::numbers::pi / 30}, frame); }

/// The payload after two laps of a ring of 30 places, with loops and open hypotheses.
std::string payload() {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  for (int frame = 0; frame < 47; ++frame) {
    step(plugin, ringStep(frame), frame < 30 ? novel(frame) : measured((frame * 7) % 30));
  }
  return tolman::test::savedPayload(plugin);
}

Status load(BayesianAttractor& plugin, const std::string& payload) {
  return tolman::test::loadPayload(plugin, "TLMBAYES", 10, payload);
}

}  // namespace

TEST_CASE("lengths that are not the payload's are refused") {
  const std::string sound = payload();
  for (std::size_t length = 0; length < sound.size(); length += 211) {
    BayesianAttractor plugin;
    REQUIRE(configure(plugin, {}).isOk());
    CHECK(load(plugin, sound.substr(0, length)).code() == StatusCode::InvalidInput);
  }
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  CHECK(load(plugin, sound + std::string(8, '\0')).message() ==
        "the saved state is damaged: wrong length");
  CHECK(load(plugin, sound).isOk());
}

TEST_CASE("counts beyond the payload end with it, also where it ends within a number") {
  const std::string sound = payload();
  for (std::size_t odd = 0; odd < 8; ++odd) {
    for (std::size_t at = 8; at + 8 <= sound.size(); at += 8 * 11) {
      std::string bytes = sound + std::string(odd, '\1');
      const std::int64_t many = std::int64_t{1} << 60;
      std::memcpy(bytes.data() + at, &many, sizeof many);
      BayesianAttractor plugin;
      REQUIRE(configure(plugin, {}).isOk());
      const Status status = load(plugin, bytes);
      if (odd > 0) REQUIRE(status.code() == StatusCode::InvalidInput);
    }
  }
}
