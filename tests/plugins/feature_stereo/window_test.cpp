// SPDX-License-Identifier: BSD-3-Clause
// The window's book-keeping against plain sets, over random sequences of its calls.
#include "window.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "tolman/context.hpp"

namespace tolman::feature_stereo {
namespace {

Landmark seenBy(const std::vector<std::int64_t>& frames) {
  Landmark landmark;
  for (const std::int64_t frame : frames) {
    Observation observation;
    observation.keyframe = frame;
    landmark.observations.push_back(observation);
  }
  return landmark;
}

Keyframe keyframe(std::int64_t frame) {
  Keyframe made;
  made.frame = frame;
  return made;
}

}  // namespace

TEST_CASE("landmarks live as long as a keyframe of the window sees them") {
  RandomStream random(14);
  Window window;
  std::map<std::int64_t, std::set<std::int64_t>> expected;  // landmark -> keyframes
  std::set<std::int64_t> ever;
  for (std::int64_t frame = 0; frame < 300; ++frame) {
    window.addKeyframe(keyframe(frame));
    for (auto& [id, seen] : expected) {
      if (random.below(2) == 0) continue;
      REQUIRE(window.find(id) != nullptr);
      Observation observation;
      observation.keyframe = frame;
      window.find(id)->observations.push_back(observation);
      seen.insert(frame);
    }
    for (std::size_t k = random.below(4); k > 0; --k) {
      const std::int64_t id = window.addLandmark(seenBy({frame}));
      REQUIRE(ever.insert(id).second);  // an id is never given twice
      expected[id] = {frame};
    }
    if (window.keyframes().size() > 5) {
      const std::int64_t oldest = window.keyframes().front().frame;
      window.dropOldest();
      for (auto& [id, seen] : expected) seen.erase(oldest);
      std::erase_if(expected, [](const auto& entry) { return entry.second.empty(); });
      REQUIRE(window.keyframes().front().frame == oldest + 1);
    }
    REQUIRE(window.landmarks().size() == expected.size());
    for (const auto& [id, seen] : expected) {
      std::set<std::int64_t> found;
      for (const Observation& o : window.landmarks().at(id).observations) found.insert(o.keyframe);
      REQUIRE(found == seen);
    }
  }
  CHECK(ever.size() > 300);
}

TEST_CASE("find() of an unknown landmark returns null and does not create one") {
  Window window;
  window.addKeyframe(keyframe(3));
  const std::int64_t id = window.addLandmark(seenBy({3}));
  CHECK(window.find(id + 1) == nullptr);
  CHECK(window.find(-1) == nullptr);
  CHECK(window.landmarks().size() == 1);
  window.find(id)->observations.clear();
  window.dropUnseen();
  CHECK(window.find(id) == nullptr);
}

TEST_CASE("clear() keeps what was learnt of the camera, and ids go on") {
  Window window;
  window.addKeyframe(keyframe(0));
  const std::int64_t first = window.addLandmark(seenBy({0}));
  window.setDisparityOffset(0.3);
  window.clear();
  CHECK(window.keyframes().empty());
  CHECK(window.landmarks().empty());
  CHECK(window.disparityOffset() == 0.3);
  window.addKeyframe(keyframe(9));
  CHECK(window.addLandmark(seenBy({9})) != first);
}

}  // namespace tolman::feature_stereo
