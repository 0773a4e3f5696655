// SPDX-License-Identifier: BSD-3-Clause
// Motions in memory and in a file are read as they were stored, bit for bit, also if the file
// cannot be written.
#include "motion_store.hpp"

#include "map_fixture.hpp"
#include "support/environment.hpp"
#include "tolman/context.hpp"

namespace tolman::experience_map {
namespace {

/// Numbers that no pose has, so that a wrong order would show.
UncertainPose randomMotion(RandomStream& random) {
  UncertainPose motion;
  for (int i = 0; i < 16; ++i) motion.T.data()[i] = random.uniform(-1, 1);
  for (int i = 0; i < 36; ++i) motion.covariance.data()[i] = random.uniform(-1, 1);
  return motion;
}

bool areEqual(const UncertainPose& a, const UncertainPose& b) {
  return a.T.matrix() == b.T.matrix() && a.covariance == b.covariance;
}

void fill(MotionStore& store, std::vector<UncertainPose>& expected, std::size_t count) {
  RandomStream random(1);
  while (expected.size() < count) {
    expected.push_back(randomMotion(random));
    store.append(expected.back());
  }
}

void checkAll(const MotionStore& store, const std::vector<UncertainPose>& expected) {
  REQUIRE(store.size() == expected.size());
  std::size_t wrong = 0;
  for (std::size_t slot = 0; slot < expected.size(); ++slot) {
    if (!areEqual(store[slot], expected[slot])) ++wrong;
    const std::size_t other = slot * 7919 % expected.size();  // far from it
    if (!areEqual(store[other], expected[other])) ++wrong;
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("motions are read as they were stored, at every length around the size of a block") {
  for (const std::size_t count : {1U, 1279U, 1280U, 1281U, 1536U, 5000U}) {
    CAPTURE(count);
    MotionStore store;
    std::vector<UncertainPose> expected;
    fill(store, expected, count);
    checkAll(store, expected);
  }
}

TEST_CASE("a motion can be replaced in memory and in the file") {
  MotionStore store;
  std::vector<UncertainPose> expected;
  fill(store, expected, 4000);
  RandomStream random(2);
  for (const std::size_t slot : {0U, 255U, 256U, 2000U, 2816U, 3999U}) {
    CHECK(areEqual(store[slot], expected[slot]));  // its block is the one read last
    expected[slot] = randomMotion(random);
    store.replace(slot, expected[slot]);
  }
  checkAll(store, expected);
}

TEST_CASE("motions stay in memory where no file can be written") {
  const test::Environment set("TMPDIR", "/nowhere/at/all");
  MotionStore store;
  std::vector<UncertainPose> expected;
  fill(store, expected, 3000);
  checkAll(store, expected);
}

}  // namespace tolman::experience_map
