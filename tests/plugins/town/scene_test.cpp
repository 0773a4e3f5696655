// SPDX-License-Identifier: BSD-3-Clause
// Rays against brute force, and the map of shadows.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "light.hpp"
#include "ray_packet.hpp"
#include "renderer.hpp"
#include "shadow_grid.hpp"
#include "small_town.hpp"
#include "tolman/context.hpp"
#include "world.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

const Vec3 kEye = {0.3F, -0.2F, 1.65F};

World handmadeWorld() {
  World world;
  const auto plain = [&](float tone, Material material = Material::Plain) {
    Surface surface;
    surface.tone = tone;
    surface.material = material;
    return world.addSurface(surface);
  };
  addQuad(world.fixed, {Vec3{-90, -90, 0}, Vec3{90, -90, 0}, Vec3{90, 90, 0}, Vec3{-90, 90, 0}},
          plain(0.2F));
  addBox(world.fixed, {-9, 14, 0}, {Vec3{5, 1, 0}, Vec3{-1, 6, 0}, Vec3{0, 0, 7}}, plain(0.5F));
  Mesh lump;
  addLump(lump, {{0, 0, 1}, {1, 1.4F, 0.8F}, 0.2F, 1, 3}, plain(0.7F));
  Mesh post;
  addPost(post, {{0, 0, 0}, {0.2F, 0, 4}, 0.4F, 0.2F, 7}, plain(0.4F));
  Mesh crown;
  addLump(crown, {{0, 0, 2}, {1, 1, 1}, 0.2F, 1, 4}, plain(0.15F, Material::Leaves));
  world.prototypes = {lump, post, crown};
  world.instances = {{0, Placement::at({4, 12, 0}, 0.7F, 1.5F), 1},
                     {1, Placement::at({-2, 9, 0.5F}, 2.1F, 0.8F), 2},
                     {0, Placement::at({1, 25, 0}, -1.2F, 2.5F), 3},
                     {2, Placement::at({8, 16, 0}, 0.3F, 1.2F), 4}};
  return world;
}

struct Triangle {
  std::array<Eigen::Vector3d, 3> corners;
  std::uint32_t surface;
};

Eigen::Vector3d wide(const Vec3& v) { return Eigen::Vector3f(v.x, v.y, v.z).cast<double>(); }

std::vector<Triangle> everyTriangle(const World& world) {
  std::vector<Triangle> all;
  const auto take = [&](const Mesh& mesh, const Placement& at) {
    const Eigen::Affine3d T = Eigen::Translation3d(wide(at.position)) *
                              Eigen::AngleAxisd(std::atan2(double(at.sine), double(at.cosine)),
                                                Eigen::Vector3d::UnitZ()) *
                              Eigen::Scaling(static_cast<double>(at.scale));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      Triangle triangle{{}, mesh.surfaces[i]};
      for (std::size_t k = 0; k < 3; ++k) {
        const Mesh::Vertex& v = mesh.vertices[mesh.triangles[i][k]];
        triangle.corners[k] = T * wide({v.x, v.y, v.z});
      }
      all.push_back(triangle);
    }
  };
  take(world.fixed, {});
  for (const MeshInstance& i : world.instances) take(world.prototypes[i.prototype], i.placement);
  return all;
}

struct Hit {
  double t = std::numeric_limits<double>::infinity();
  const Triangle* triangle = nullptr;
  bool on_edge = false;  ///< some triangle is met so near its edge that rounding decides
};

/// The first triangle on origin + t d, by solving for t and two edge coordinates.
Hit bruteForce(const std::vector<Triangle>& triangles, const Eigen::Vector3d& origin,
               const Eigen::Vector3d& d, double nearest) {
  Hit hit;
  for (const Triangle& triangle : triangles) {
    Eigen::Matrix3d system;
    system << -d, triangle.corners[1] - triangle.corners[0],
        triangle.corners[2] - triangle.corners[0];
    if (std::abs(system.determinant()) < 1e-12) continue;
    const Eigen::Vector3d x = system.partialPivLu().solve(origin - triangle.corners[0]);
    const double margin = std::min({x[1], x[2], 1 - x[1] - x[2]});
    if (x[0] <= nearest) continue;
    if (std::abs(margin) < 1e-4) hit.on_edge = true;
    if (margin >= 0 && x[0] < hit.t) hit = {x[0], &triangle, hit.on_edge};
  }
  return hit;
}

Vec3 normalOf(const Triangle& triangle, const Eigen::Vector3d& seen_along) {
  Eigen::Vector3d n = (triangle.corners[1] - triangle.corners[0])
                          .cross(triangle.corners[2] - triangle.corners[0])
                          .normalized();
  if (n.dot(seen_along) > 0) n = -n;
  const Eigen::Vector3f f = n.cast<float>();
  return {f.x(), f.y(), f.z()};
}

/// A scene under a high sun; pixels so wide that every texture has averaged out to its tone.
struct Setting {
  Setting() : scene(handmadeWorld()), triangles(everyTriangle(handmadeWorld())) {
    light.to_sun = normalised({0.5F, -0.3F, 0.9F});
    light.clouds = 0;
    around = {&scene, &plan, &light, nullptr, {400, 0, 0}, {0, 0, -400}};
  }
  std::vector<Shaded> shade(const std::vector<Vec3>& directions) const {
    std::vector<Shaded> all;
    RayPacket packet(around);
    for (const Vec3& direction : directions) {
      packet.add(kEye, direction);
      if (!packet.isFull() && &direction != &directions.back()) continue;
      const int size = packet.size();
      const auto shaded = packet.shade();
      all.insert(all.end(), shaded.begin(), shaded.begin() + size);
    }
    return all;
  }

  Scene scene;
  StreetPlan plan;
  Light light;
  Surroundings around;
  std::vector<Triangle> triangles;
};

std::vector<Vec3> fan(std::uint64_t seed, int count) {
  RandomStream random(seed);
  const auto draw = [&](double low, double high) {
    return static_cast<float>(random.uniform(low, high));
  };
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    directions.push_back(Vec3{draw(-0.8, 0.8), 1, draw(-0.35, 0.45)} * draw(0.5, 2));
  }
  return directions;
}

}  // namespace

TEST_CASE("a packet meets the triangle that brute force finds, fixed or placed") {
  const Setting setting;
  const std::vector<Vec3> directions = fan(7, 1603);  // the last packet is not full
  const std::vector<Shaded> shaded = setting.shade(directions);
  REQUIRE(shaded.size() == directions.size());
  int sky = 0;
  int placed = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Hit hit = bruteForce(setting.triangles, wide(kEye), wide(directions[i]), 0.05);
    if (hit.on_edge) continue;
    CAPTURE(i, directions[i].x, directions[i].z);
    if (!hit.triangle) {
      REQUIRE(shaded[i].depth == 0);
      REQUIRE(shaded[i].seen == 0);
      REQUIRE(shaded[i].radiance == lightFromSky(setting.light, vec3s(directions[i]), 400)[0]);
      ++sky;
      continue;
    }
    REQUIRE(double(shaded[i].depth) == Approx(hit.t).epsilon(1e-4));
    REQUIRE(shaded[i].seen != 0);
    placed += hit.triangle->surface > 1;
  }
  CHECK(sky > 100);
  CHECK(placed > 100);
}

TEST_CASE("light is tone times what falls on the surface, and none of the sun in a shadow") {
  const Setting setting;
  const std::vector<Vec3> directions = fan(8, 1200);
  const std::vector<Shaded> shaded = setting.shade(directions);
  const World world = handmadeWorld();
  std::array<int, 2> count{};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Hit hit = bruteForce(setting.triangles, wide(kEye), wide(directions[i]), 0.05);
    if (hit.on_edge || !hit.triangle) continue;
    const Surface& surface = world.surfaces[hit.triangle->surface];
    if (surface.material == Material::Leaves) continue;
    const Vec3 normal = normalOf(*hit.triangle, wide(directions[i]));
    const Eigen::Vector3d point = wide(kEye) + hit.t * wide(directions[i]);
    const Hit blocker =
        bruteForce(setting.triangles, point + 5e-3 * wide(normal), wide(setting.light.to_sun), 0);
    if (blocker.on_edge) continue;
    const float lit = blocker.triangle ? 0.0F : 1.0F;
    CAPTURE(i, lit, point.transpose());
    REQUIRE(shaded[i].radiance ==
            Approx(surface.tone * setting.light.onto(normal, lit)).epsilon(1e-3));
    if (normal.z > 0.9F) ++count[blocker.triangle ? 0 : 1];
  }
  CHECK(count[0] > 10);
  CHECK(count[1] > 100);
}

TEST_CASE("haze takes contrast exponentially with the way, whatever the direction's length") {
  Setting setting;
  const std::vector<Vec3> directions = fan(9, 400);
  const std::vector<Shaded> clear = setting.shade(directions);
  setting.light.haze = 0.02F;
  const std::vector<Shaded> hazy = setting.shade(directions);
  const float horizon = setting.light.horizon;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (clear[i].depth == 0) continue;
    const float way = clear[i].depth * norm(directions[i]);
    REQUIRE(hazy[i].radiance - horizon ==
            Approx((clear[i].radiance - horizon) * std::exp(-0.02F * way)).margin(1e-5));
  }
}

TEST_CASE("an instance that moves takes its picture along") {
  Setting setting;
  const Vec3 there = {20, 30, 1.65F};
  const float before = setting.shade({there - kEye}).front().depth;
  setting.scene.move(1, Placement::at({20, 30, 0}, 0, 1));
  setting.scene.commit();
  const float after = setting.shade({there - kEye}).front().depth;
  CHECK(before == 0);  // sky beyond the level of the eye
  CHECK(after == Approx(1).margin(0.02));
}

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
