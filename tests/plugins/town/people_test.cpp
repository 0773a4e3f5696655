// SPDX-License-Identifier: BSD-3-Clause
// Bodies of people and cyclists: their size, that they stand on the ground, and that they move.
#include "people.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "pedestrians.hpp"

using namespace tolman::town;

namespace {

struct Extent {
  Vec3 low = {1e9F, 1e9F, 1e9F};
  Vec3 high = {-1e9F, -1e9F, -1e9F};
};

Extent extentOf(const Mesh& mesh) {
  Extent e;
  for (const Mesh::Vertex& v : mesh.vertices) {
    e.low = {std::min(e.low.x, v.x), std::min(e.low.y, v.y), std::min(e.low.z, v.z)};
    e.high = {std::max(e.high.x, v.x), std::max(e.high.y, v.y), std::max(e.high.z, v.z)};
  }
  return e;
}

}  // namespace

TEST_CASE("walkers are as large as people and touch the ground in each posture") {
  World world;
  const std::vector<std::uint32_t> postures = addWalkers(world);
  REQUIRE(postures.size() == kGaitPhases + 1);
  float longest = 0;
  for (const std::uint32_t posture : postures) {
    const Extent e = extentOf(world.prototypes.at(posture));
    CHECK(e.high.z == Approx(1.77).margin(0.06));
    CHECK(e.low.z == Approx(0).margin(0.09));
    CHECK(e.high.y - e.low.y == Approx(0.54).margin(0.08));
    longest = std::max(longest, e.high.x - e.low.x);
  }
  const Extent stands = extentOf(world.prototypes[postures[kStanding]]);
  CHECK(stands.high.x - stands.low.x < 0.5F);
  CHECK(longest > 0.7F);  // a step
}

TEST_CASE("opposite phases of a step are mirror images") {
  World world;
  const std::vector<std::uint32_t> postures = addWalkers(world);
  for (int i = 0; i < kGaitPhases / 2; ++i) {
    const Extent a = extentOf(world.prototypes[postures[static_cast<std::size_t>(i)]]);
    const Extent b =
        extentOf(world.prototypes[postures[static_cast<std::size_t>(i + kGaitPhases / 2)]]);
    CHECK(a.high.x == Approx(b.high.x).margin(0.01));
    CHECK(a.low.z == Approx(b.low.z).margin(0.01));
    CHECK(a.high.y == Approx(-b.low.y).margin(0.01));
  }
}

TEST_CASE("cyclists are as long as a bicycle, and their feet go round") {
  World world;
  const std::vector<std::uint32_t> postures = addCyclists(world);
  REQUIRE(postures.size() == kPedalPhases);
  for (const std::uint32_t posture : postures) {
    const Mesh& mesh = world.prototypes.at(posture);
    const Extent e = extentOf(mesh);
    CHECK(e.high.x - e.low.x == Approx(1.76).margin(0.1));
    CHECK(e.low.z == Approx(0).margin(0.03));
    CHECK(e.high.z == Approx(1.78).margin(0.1));
    REQUIRE(mesh.surfaces.size() == mesh.triangles.size());
    for (const std::uint32_t surface : mesh.surfaces) REQUIRE(surface < world.surfaces.size());
  }
  const auto& first = world.prototypes[postures[0]].vertices;
  const auto& second = world.prototypes[postures[1]].vertices;
  REQUIRE(first.size() == second.size());
  const auto moved = std::count_if(first.begin(), first.end(), [&](const Mesh::Vertex& v) {
    const Mesh::Vertex& w = second[static_cast<std::size_t>(&v - first.data())];
    return std::abs(v.z - w.z) > 0.05F;
  });
  CHECK(moved > 20);
}
