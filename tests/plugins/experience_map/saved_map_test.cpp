// SPDX-License-Identifier: BSD-3-Clause
// Saved maps with a valid checksum and wrong contents: counts, lengths, order. Also the round trip
// of maps of random drives.
#include "saved_map.hpp"

#include <cstring>

#include "map_fixture.hpp"
#include "support/saved_payload.hpp"

using namespace tolman;
using namespace tolman::experience_map;

namespace {

/// Creates, stays and closes loops as it comes; every pose noisy.
void driveAtRandom(Fixture& f, std::uint64_t seed, int frames) {
  RandomStream random(seed);
  f.create(step(0));
  for (int i = 1; i < frames; ++i) {
    const Eigen::Isometry3d motion = step(random.uniform(0.5, 2), random.uniform(-0.2, 0.25));
    const std::uint64_t what = random.below(8);
    if (what < 3 || f.created < 3) {
      f.create(motion);
    } else if (what == 3) {
      f.closeMeasured(motion, static_cast<std::int64_t>(random.below(2)),
                      fromPlanar({random.normal(), random.normal(), 0.1}));
    } else if (what == 4) {
      f.close(motion, static_cast<std::int64_t>(random.below(2)), random.uniform(-0.1, 0.1));
    } else {
      f.stay(motion);
    }
  }
}

std::string payloadOf(const Fixture& f) { return tolman::test::savedPayload(f.map); }

Status load(Fixture& f, const std::string& payload) {
  return tolman::test::loadPayload(f.map, "TLMEXMAP", 4, payload);
}

std::string with(std::string payload, std::size_t word, std::int64_t value) {
  std::memcpy(payload.data() + 8 * word, &value, sizeof value);
  return payload;
}

}  // namespace

TEST_CASE("maps driven at random are the same after loading, byte for byte and pose for pose") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Fixture saved;
    driveAtRandom(saved, seed, 60);
    Fixture loaded;
    const std::string payload = payloadOf(saved);
    REQUIRE(load(loaded, payload).isOk());
    CHECK(payloadOf(loaded) == payload);
    for (std::int64_t frame = 0; frame < saved.frame; ++frame) {
      REQUIRE(loaded.poseOf(frame).matrix() == saved.poseOf(frame).matrix());
    }
    const MapGraph a = saved.graph();
    const MapGraph b = loaded.graph();
    REQUIRE(a.experiences.size() == b.experiences.size());
    REQUIRE(a.links.size() == b.links.size());
    for (std::size_t i = 0; i < a.links.size(); ++i) {
      REQUIRE(a.links[i].from == b.links[i].from);
      REQUIRE(a.links[i].to == b.links[i].to);
    }
    CHECK(a.rejected == b.rejected);
  }
}

TEST_CASE("every other length is refused, also one that ends within a number") {
  Fixture saved;
  driveAtRandom(saved, 3, 12);
  const std::string sound = payloadOf(saved);
  for (std::size_t length = 0; length < sound.size(); length += 37) {
    Fixture f;
    CAPTURE(length);
    REQUIRE(load(f, sound.substr(0, length)).code() == StatusCode::InvalidInput);
  }
  for (std::size_t more = 1; more < 12; ++more) {
    Fixture f;
    CHECK(load(f, sound + std::string(more, '\0')).message() ==
          "the saved map is damaged: wrong length");
  }
}

TEST_CASE("counts that the bytes do not hold are refused, whatever is left at the end") {
  Fixture saved;
  driveAtRandom(saved, 4, 12);
  const std::string sound = payloadOf(saved);
  constexpr std::size_t kFrames = 2;  // words before the list of frames: version, next correction
  for (const std::int64_t count : {std::int64_t{-1}, std::int64_t{11}, std::int64_t{13},
                                   std::int64_t{1} << 40, std::int64_t{0x7fffffffffffffff}}) {
    for (const std::size_t odd : {0U, 1U, 4U, 7U}) {
      Fixture f;
      CAPTURE(count, odd);
      CHECK(load(f, with(sound, kFrames, count) + std::string(odd, '\1')).code() ==
            StatusCode::InvalidInput);
      f.create(step(0));  // a fresh map
      CHECK(f.graph().experiences.size() == 1);
    }
  }
}

TEST_CASE("an empty map is saved and loaded as one") {
  const Fixture empty;
  Fixture loaded;
  REQUIRE(load(loaded, payloadOf(empty)).isOk());
  loaded.create(step(0));
  CHECK(loaded.graph().experiences.size() == 1);
}
