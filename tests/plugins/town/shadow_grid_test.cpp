// SPDX-License-Identifier: BSD-3-Clause
// The map of shadows leaves out no point that something may shade, and most that nothing shades.
#include "shadow_grid.hpp"

#include <catch2/catch.hpp>

#include "renderer.hpp"
#include "small_town.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

constexpr Vec3 kSun = {0.4F, -0.5F, 0.76F};
constexpr GroundArea kArea = {{-60, -40, 0}, {50, 70, 0}};

struct Found {
  bool fixed;
  bool placed;
};

Found look(const ShadowGrid& grid, const Vec3& point) {
  EightInts fixed;
  EightInts placed;
  grid.look(vec3s(point), fixed, placed);
  return {fixed[3] != 0, placed[3] != 0};
}

float draw(RandomStream& random, double low, double high) {
  return static_cast<float>(random.uniform(low, high));
}

Vec3 somewhere(RandomStream& random) {
  return {draw(random, -30, 30), draw(random, -20, 40), draw(random, -2, 12)};
}

std::array<Vec3, 8> boxAt(const Vec3& low, const Vec3& size) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = low + Vec3{(i & 1U) != 0 ? size.x : 0, (i & 2U) != 0 ? size.y : 0,
                            (i & 4U) != 0 ? size.z : 0};
  }
  return corners;
}

}  // namespace

TEST_CASE("whatever is on a ray to the sun through a triangle is where the map marks it") {
  RandomStream random(1);
  for (int i = 0; i < 400; ++i) {
    ShadowGrid grid;
    grid.start(kSun, kArea);
    const std::array<Vec3, 3> corners = {somewhere(random), somewhere(random), somewhere(random)};
    grid.mark(corners);
    for (int k = 0; k < 50; ++k) {
      const float a = draw(random, 0, 1);
      const float b = draw(random, 0, 1) * (1 - a);
      const Vec3 inside = corners[0] * (1 - a - b) + corners[1] * a + corners[2] * b;
      const Found found = look(grid, inside - kSun * draw(random, 0, 20));
      REQUIRE(found.fixed);
    }
  }
}

TEST_CASE("the map leaves free what is away from a triangle") {
  ShadowGrid grid;
  grid.start(kSun, kArea);
  grid.mark({Vec3{0, 0, 0}, Vec3{8, 0, 0}, Vec3{0, 8, 0}});
  CHECK(look(grid, {2, 2, 0}).fixed);
  CHECK_FALSE(look(grid, {2, 2, 0}).placed);
  for (const Vec3& free : {Vec3{-2, 2, 0}, Vec3{2, -2, 0}, Vec3{7, 7, 0}, Vec3{2, 2, 30}}) {
    CHECK_FALSE(look(grid, free).fixed);
  }
  CHECK(look(grid, {70, 0, 0}).fixed);  // outside of the map anything is possible
  CHECK(look(grid, {70, 0, 0}).placed);
}

TEST_CASE("boxes are marked as instances, and those that move are forgotten") {
  RandomStream random(2);
  ShadowGrid grid;
  grid.start(kSun, kArea);
  const Vec3 size = {3, 2, 6};
  grid.mark(boxAt({-20, 5, 0}, size), false);
  grid.mark(boxAt({10, 5, 0}, size), true);
  for (int i = 0; i < 200; ++i) {
    const Vec3 within = {draw(random, 0, 3), draw(random, 0, 2), draw(random, 0, 6)};
    const Vec3 away = kSun * draw(random, 0, 9);
    REQUIRE(look(grid, Vec3{-20, 5, 0} + within - away).placed);
    REQUIRE(look(grid, Vec3{10, 5, 0} + within - away).placed);
    REQUIRE_FALSE(look(grid, Vec3{10, 5, 0} + within - away).fixed);
  }
  grid.forgetMoving();
  CHECK(look(grid, {-19, 6, 0}).placed);
  CHECK_FALSE(look(grid, {11, 6, 0}).placed);
}

TEST_CASE("without a map, and under a sun at the horizon, every ray is wanted") {
  ShadowGrid grid;
  CHECK(look(grid, {0, 0, 0}).fixed);
  CHECK(look(grid, {0, 0, 0}).placed);
  grid.start({1, 0, 0.05F}, kArea);
  CHECK_FALSE(grid.isOn());
  grid.start(kSun, {{0, 0, 0}, {0, 0, 0}});
  CHECK_FALSE(grid.isOn());
}

// At the foot of kerbs rays to the sun, which start a little before a surface, meet the ground
// itself now and then; with the map they do not.
TEST_CASE("pictures have the same shadows with the map") {
  town::test::SmallTown town;
  Renderer renderer(town.scene, town.plan, town.light, 2);
  RenderedImage without;
  RenderedImage with;
  std::size_t differing = 0;
  std::size_t pixels = 0;
  for (const std::size_t frame : {20U, 90U, 170U}) {
    const RenderCamera view = town.view(town.route.T_town_camera[frame]);
    town.scene.setSun({0, 0, 0.01F});
    REQUIRE_FALSE(town.scene.shadows().isOn());
    renderer.render(view, without);
    town.scene.setSun(town.light.to_sun);
    REQUIRE(town.scene.shadows().isOn());
    renderer.render(view, with);
    CHECK(with.depth == without.depth);
    for (std::size_t i = 0; i < with.radiance.size(); ++i) {
      differing += with.radiance[i] != without.radiance[i];
    }
    pixels += with.radiance.size();
  }
  CHECK(differing * 20000 <= pixels);
}
