// SPDX-License-Identifier: BSD-3-Clause
// Poses measured on a stored path: the right ones are consistent with odometry.
#include <catch2/catch.hpp>
#include <cmath>

#include "part_state.hpp"
#include "place_verifier.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

/// Where the pass of now began in the frame of the stored path, for a robot that is really there.
constexpr PlanarPose kStart = {40, -3, 3.0};

PlanarPose drivenTo(double metres) { return {metres, 0.01 * metres * metres, 0.02 * metres}; }

bool measure(PoseAgreement& poses, double path, const PlanarPose& error = {}) {
  return poses.add(path, compose(compose(kStart, drivenTo(path)), error), drivenTo(path));
}

std::string bytesOf(const PoseAgreement& poses) {
  return savedBytes([&](StateWriter& writer) { poses.save(writer); });
}

bool takes(PoseAgreement& poses, const std::string& bytes) {
  StateReader reader = readerOf(bytes);
  return poses.load(reader) && reader.complete();
}

}  // namespace

TEST_CASE("poses on a path that is really driven agree, once they are four metres apart") {
  PoseAgreement poses;
  CHECK_FALSE(measure(poses, 0));
  for (int path = 1; path <= 3; ++path) CHECK_FALSE(measure(poses, path));
  for (int path = 4; path <= 30; ++path) CHECK(measure(poses, path, {0.5, -0.3, 0.03}));
  CHECK_FALSE(measure(poses, 43));  // the last one was 13 m ago
  CHECK(measure(poses, 49));
  poses.forget();
  CHECK_FALSE(measure(poses, 53));
}

TEST_CASE("a chance match that stays in place, jumps or turns does not agree") {
  for (const PlanarPose& error :
       {PlanarPose{2, 0, 0}, PlanarPose{-2, 0, 0}, PlanarPose{0, 2, 0}, PlanarPose{0, 0, 0.2}}) {
    PoseAgreement poses;
    measure(poses, 0);
    CHECK_FALSE(measure(poses, 6, error));
    CHECK(measure(poses, 7));  // the first one still counts
  }
  PoseAgreement same_place;
  for (int path = 0; path < 20; ++path) {
    CHECK_FALSE(same_place.add(path, kStart, {static_cast<double>(path), 0, 0}));
  }
}

TEST_CASE("headings agree across half a turn") {
  PoseAgreement poses;
  poses.add(0, {0, 0, 3.13}, {0, 0, 0});
  CHECK(poses.add(5, {-5, 0, -3.13}, {5, 0, 0}));
}

TEST_CASE("saved poses go on to the bit, and damaged ones are refused") {
  PoseAgreement poses;
  for (int path = 0; path < 15; path += 2) measure(poses, path);
  const std::string bytes = bytesOf(poses);
  PoseAgreement loaded;
  measure(loaded, 3);  // forgotten
  REQUIRE(takes(loaded, bytes));
  CHECK(bytesOf(loaded) == bytes);
  CHECK(measure(poses, 19) == measure(loaded, 19));
  CHECK(bytesOf(loaded) == bytesOf(poses));
  for (std::size_t length = 0; length < bytes.size(); length += 5) {
    CHECK_FALSE(takes(loaded, bytes.substr(0, length)));
  }
  CHECK_FALSE(takes(loaded, overwritten(bytes, 0, std::uint64_t{1} << 50U)));
  CHECK_FALSE(takes(loaded, overwritten(bytes, 8, double(NAN))));
  CHECK_FALSE(takes(loaded, overwritten(bytes, 24, double(INFINITY))));
}
