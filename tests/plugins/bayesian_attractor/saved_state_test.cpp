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
  return tolman::test::loadPayload(plugin, "TLMBAYES", 7, payload);
}

/// Goes on for a lap; what it answers is checked as the host checks it.
void goOn(BayesianAttractor& plugin) {
  for (int frame = 47; frame < 77; ++frame) {
    Decision decision;
    const Status status = plugin.step(ringStep(frame), measured(frame % 30), decision);
    if (status.isOk()) REQUIRE(firstInvalidField(decision).empty());
  }
  std::vector<NamedArray> arrays;
  plugin.arrays(arrays);
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

TEST_CASE("covariances and poses that are none are refused") {
  const std::string sound = payload();
  const std::size_t modules = 4;     // of the default parameters
  constexpr std::size_t kFirst = 3;  // words: period, modules, period of heights
  const std::size_t covariance = kFirst + 1 + 3 * modules;
  for (const double wrong : {-1.0, 1e300}) {
    std::string bytes = sound;
    std::memcpy(bytes.data() + 8 * covariance, &wrong, sizeof wrong);
    BayesianAttractor plugin;
    REQUIRE(configure(plugin, {}).isOk());
    CHECK(load(plugin, bytes).message() == "the saved state is damaged: numbers that cannot be");
  }
}

TEST_CASE("a number that is none is refused wherever it stands") {
  const std::string sound = payload();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int refused = 0;
  int taken = 0;
  for (std::size_t at = 16; at + sizeof nan <= sound.size(); at += 8 * 5) {
    std::string bytes = sound;
    std::memcpy(bytes.data() + at, &nan, sizeof nan);
    BayesianAttractor plugin;
    REQUIRE(configure(plugin, {}).isOk());
    if (const Status status = load(plugin, bytes); status.isOk()) {
      ++taken;  // the word is a whole number
      goOn(plugin);
    } else {
      CHECK(status.code() == StatusCode::InvalidInput);
      ++refused;
      CHECK(step(plugin, ringStep(0), novel(0)).experience == 0);  // as after reset
    }
  }
  CHECK(refused > 5 * taken);
  CHECK(refused > 100);
}

TEST_CASE("whole numbers that are wild are refused, or change no more than decisions") {
  const std::string sound = payload();
  int refused = 0;
  for (std::size_t at = 0; at + 8 <= sound.size(); at += 8 * 3) {
    for (const std::uint64_t wild : {~0ULL, 1ULL << 40U, 0x7fffffffffffffffULL}) {
      std::string bytes = sound;
      std::memcpy(bytes.data() + at, &wild, sizeof wild);
      BayesianAttractor plugin;
      REQUIRE(configure(plugin, {}).isOk());
      if (load(plugin, bytes).isOk()) {
        goOn(plugin);
      } else {
        ++refused;
      }
    }
  }
  CHECK(refused > 100);
}
