// SPDX-License-Identifier: BSD-3-Clause
// Saved states with a valid envelope and wrong contents: refused at once, or used without failure.
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>

#include "place_replay.hpp"
#include "support/context.hpp"
#include "support/saved_payload.hpp"

using namespace tolman;
using namespace tolman::place_replay;

namespace {

/// A plugin that drops and invents candidates, so that all of its state is used.
struct SavedReplay {
  SavedReplay()
      : context({{"relative_pose", true},
                 {"kept", 0.7},
                 {"invented", 0.5},
                 {"invented_run", std::int64_t{20}}}) {
    REQUIRE(place.configure(context).isOk());
  }
  PlaceObservation look(std::int64_t index) {
    Frame frame;
    frame.frame = frame.source_index = index;
    frame.sensors.push_back({"place.candidate", {1, 4}, {10, 1, 0, 0}});
    Motion motion;
    motion.state = TrackingState::Tracking;
    motion.T_previous_current = fromPlanar({1, 0, 0});
    PlaceObservation observation;
    REQUIRE(place.observe(frame, &motion, observation).isOk());
    REQUIRE(firstInvalidField(observation).empty());
    return observation;
  }
  Status load(const std::string& payload) {
    return test::loadPayload(place, "TLMPLRPL", 4, payload);
  }

  test::TestContext context;
  PlaceReplay place;
};

std::string payload() {
  SavedReplay replay;
  for (std::int64_t i = 0; i < 150; ++i) replay.look(i);
  return test::savedPayload(replay.place);
}

}  // namespace

TEST_CASE("every other length is refused at once, whatever the count of views says") {
  const std::string sound = payload();
  constexpr std::size_t kCount = 4 * 8 + 8 + 4 + 4 * 8;  // words, templates, drive, four indices
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{0x7fffffffffffffff}}) {
    std::string bytes = sound;
    if (count > 0) std::memcpy(bytes.data() + kCount, &count, sizeof count);
    for (std::size_t length = 0; length < bytes.size(); length += 3) {
      SavedReplay replay;
      CAPTURE(count, length);
      REQUIRE(replay.load(bytes.substr(0, length)).message() ==
              "the saved views are damaged: numbers that cannot be");
    }
    for (std::size_t more = 1; more < 9; ++more) {
      SavedReplay replay;
      REQUIRE_FALSE(replay.load(bytes + std::string(more, '\0')).isOk());
    }
  }
  SavedReplay replay;
  CHECK(replay.load(sound).isOk());
}

TEST_CASE("indices whose differences are no index are refused") {
  const std::string sound = payload();
  constexpr std::size_t kFirstView = 4 * 8 + 8 + 4 + 4 * 8 + 8;
  for (const std::int64_t index : {INT64_MIN + 2, INT64_MAX}) {
    std::string bytes = sound;
    std::memcpy(bytes.data() + kFirstView, &index, sizeof index);
    SavedReplay replay;
    CHECK(replay.load(bytes).message() == "the saved views are damaged: numbers that cannot be");
  }
}

TEST_CASE("wild numbers are refused, or views are reported that the host accepts") {
  const std::string sound = payload();
  int refused = 0;
  int taken = 0;
  for (std::size_t at = 0; at + 8 <= sound.size(); at += 4) {
    for (const double wild : {std::numeric_limits<double>::quiet_NaN(), -1.0, 1e300}) {
      std::string bytes = sound;
      std::memcpy(bytes.data() + at, &wild, sizeof wild);
      SavedReplay replay;
      if (replay.load(bytes).isOk()) {
        ++taken;
        for (std::int64_t i = 150; i < 165; ++i) replay.look(i);
      } else {
        ++refused;
        CHECK(replay.look(0).recognition == Recognition::Novel);  // as after reset
      }
    }
  }
  CHECK(refused > 50);
  CHECK(taken > 50);
}
