// SPDX-License-Identifier: BSD-3-Clause
// Lamps, signs, fences and hedges are at the given places, dashes on the middle of the road; the
// horizon is closed.
#include "furniture.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "drawn_route.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

Eigen::Vector3d wide(const Mesh::Vertex& v) {
  return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

/// A stand that looks along a street of any heading.
Stand turnedStand(double yaw, std::uint32_t seed) {
  const auto c = static_cast<float>(std::cos(yaw));
  const auto s = static_cast<float>(std::sin(yaw));
  return {{12, -7, 3}, {c, s, 0}, {-s, c, 0}, seed};
}

struct Reach {
  double inward_low = 1e9;
  double inward_high = -1e9;
  double along = 0;  ///< at most, to either side
  double low = 1e9;
  double high = -1e9;
};

/// Of all vertices, in the axes of the stand.
Reach reachOf(const World& world, const Stand& stand) {
  Reach reach;
  for (const Mesh::Vertex& v : world.fixed.vertices) {
    const Vec3 d = Vec3{v.x, v.y, v.z} - stand.foot;
    const auto inward = static_cast<double>(dot(d, stand.inward));
    reach.inward_low = std::min(reach.inward_low, inward);
    reach.inward_high = std::max(reach.inward_high, inward);
    reach.along = std::max(reach.along, std::abs(static_cast<double>(dot(d, stand.along))));
    reach.low = std::min(reach.low, static_cast<double>(d.z));
    reach.high = std::max(reach.high, static_cast<double>(d.z));
  }
  return reach;
}

StreetPlan straightPlan() {
  CameraRoute route;
  for (int i = 0; i <= 200; ++i) {
    route.stamps_ns.push_back(std::int64_t{i} * 100'000'000);
    route.T_town_camera.push_back(
        town::test::levelPose({Eigen::Vector2d(0, i), Eigen::Vector2d(0, 1)}, 1.65));
  }
  return StreetPlan::grow(route, 1.65).value();
}

}  // namespace

TEST_CASE("a lamp stands in the ground and reaches over the street, whatever its heading") {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Stand stand = turnedStand(0.7 * seed, seed);
    World world;
    addLamp(world, stand);
    const Reach reach = reachOf(world, stand);
    CAPTURE(seed);
    CHECK(reach.low < -0.2);
    CHECK(reach.high > 5);
    CHECK(reach.high < 8.6);
    CHECK(reach.inward_low > -0.2);
    CHECK(reach.inward_high > 1.8);
    CHECK(reach.inward_high < 2.2);
    CHECK(reach.along < 0.2);
  }
}

TEST_CASE("signs and posters leave room below, and their boards face along the street") {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Stand stand = turnedStand(0.9 * seed, seed);
    for (const bool poster : {false, true}) {
      World world;
      poster ? addPoster(world, stand) : addSign(world, stand);
      const auto board =
          std::find_if(world.surfaces.begin(), world.surfaces.end(),
                       [](const Surface& s) { return s.material == Material::Board; });
      REQUIRE(board != world.surfaces.end());
      const auto index = static_cast<std::uint32_t>(board - world.surfaces.begin());
      double low = 1e9;
      double across = 0;
      for (std::size_t i = 0; i < world.fixed.triangles.size(); ++i) {
        if (world.fixed.surfaces[i] != index) continue;
        for (const std::uint32_t corner : world.fixed.triangles[i]) {
          const Mesh::Vertex& v = world.fixed.vertices[corner];
          const Vec3 d = Vec3{v.x, v.y, v.z} - stand.foot;
          low = std::min(low, static_cast<double>(d.z));
          across = std::max(across, std::abs(static_cast<double>(dot(d, stand.along))));
          // The pattern's coordinates cover the board from corner to corner.
          const Vec3 local = Vec3{v.x, v.y, v.z} - board->origin;
          REQUIRE(dot(local, board->axis_u) > -1e-3F);
          REQUIRE(dot(local, board->axis_u) < board->width + 1e-3F);
          REQUIRE(dot(local, board->axis_v) < board->height + 1e-3F);
        }
      }
      CHECK(low == Approx(poster ? 1.2 : 2.1).margin(1e-3));
      CHECK(across < 0.1);  // thin
      CHECK(reachOf(world, stand).low < -0.2);
    }
  }
}

TEST_CASE("fences and hedges fill their plot and no more") {
  RandomStream random(3);
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const double angle = random.uniform(0, 6.28);
    const Plot plot = {{random.uniform(-50, 50), random.uniform(-50, 50)},
                       {std::cos(angle), std::sin(angle)},
                       random.uniform(2, 9),
                       random.uniform(0.04, 0.5)};
    World world;
    seed % 2 == 0 ? addFence(world, plot, 4, seed) : addHedge(world, plot, 4, seed);
    double along = 0;
    double over = 0;
    double high = 0;
    for (const Mesh::Vertex& v : world.fixed.vertices) {
      const Eigen::Vector2d d = wide(v).head<2>() - plot.centre;
      along = std::max(along, std::abs(d.dot(plot.axis)));
      over = std::max(over, std::abs(d.dot(plot.across())));
      high = std::max(high, wide(v).z());
    }
    CHECK(along == Approx(plot.half_length).margin(1e-3));
    CHECK(over == Approx(plot.half_depth).margin(1e-3));
    CHECK(high > 4.7);
    CHECK(high < 6);
  }
}

TEST_CASE("dashes of 3 m every 9 m lie on the middle of the road, just above it") {
  const StreetPlan plan = straightPlan();
  World world;
  addLaneMarkings(world, plan, 1);
  double painted = 0;
  for (const auto& [a, b, c] : world.fixed.triangles) {
    const Eigen::Vector3d u = wide(world.fixed.vertices[b]) - wide(world.fixed.vertices[a]);
    const Eigen::Vector3d v = wide(world.fixed.vertices[c]) - wide(world.fixed.vertices[a]);
    painted += 0.5 * u.cross(v).norm();
    CHECK(u.cross(v).z() > 0);
  }
  const double length = plan.sections().at(0).points.back().s;
  CHECK(painted == Approx(length / 3 * 0.12).epsilon(0.03));
  for (const Mesh::Vertex& v : world.fixed.vertices) {
    const Eigen::Vector3d p = wide(v);
    REQUIRE(plan.distance(p.x(), p.y()) < 0.1);
    const double above = p.z() - plan.height(p.x(), p.y());
    REQUIRE(above > 0.005);
    REQUIRE(above < 0.02);
  }
}

TEST_CASE("no dash crosses a junction") {
  const StreetPlan plan = StreetPlan::grow(town::test::builtIn("eights"), 1.65).value();
  World world;
  addLaneMarkings(world, plan, 1);
  REQUIRE(world.fixed.triangles.size() > 50);
  // Each dash has a centreline of its own street below it; at a junction another one is near too.
  for (const auto& corners : world.fixed.triangles) {
    const Eigen::Vector2d p = wide(world.fixed.vertices[corners[0]]).head<2>();
    std::vector<double> distances;
    for (const StreetSection& section : plan.sections()) {
      double nearest = 1e9;
      for (const StreetPoint& point : section.points) {
        nearest = std::min(nearest, (point.position - p).norm());
      }
      distances.push_back(nearest);
    }
    std::sort(distances.begin(), distances.end());
    CHECK(distances[0] < 1);
    if (distances.size() > 1) CHECK(distances[1] > 0.5 * StreetPlan::kRoadHalfWidth);
  }
}

TEST_CASE("from every point of the street the horizon is closed all around") {
  const StreetPlan plan = straightPlan();
  World world;
  addHorizon(world, plan, 4);
  for (const double y : {0.0, 100.0, 200.0}) {
    const Eigen::Vector3d eye(0, y, 1.65);
    for (int i = 0; i < 360; ++i) {
      const double angle = i * std::numbers::pi / 180;
      const Eigen::Vector3d ray(std::cos(angle), std::sin(angle), 0);
      int met = 0;
      for (const auto& [a, b, c] : world.fixed.triangles) {
        const Eigen::Vector3d origin = wide(world.fixed.vertices[a]);
        Eigen::Matrix3d system;
        system << -ray, wide(world.fixed.vertices[b]) - origin,
            wide(world.fixed.vertices[c]) - origin;
        const Eigen::Vector3d x = system.inverse() * (eye - origin);
        met += x[0] > 100 && x[1] >= -1e-6 && x[2] >= -1e-6 && x[1] + x[2] <= 1 + 1e-6;
      }
      CAPTURE(y, i);
      REQUIRE(met >= 1);
    }
  }
}

TEST_CASE("guard rails run along both sides, with a post every 4 m") {
  const StreetPlan plan = straightPlan();
  World world;
  addGuardRails(world, plan);
  double longest = 0;
  for (const Mesh::Vertex& v : world.fixed.vertices) {
    const double from_road = plan.distance(static_cast<double>(v.x), static_cast<double>(v.y));
    CHECK(from_road == Approx(StreetPlan::kRoadHalfWidth + 0.5).margin(0.15));
    const double above =
        static_cast<double>(v.z) - plan.height(static_cast<double>(v.x), static_cast<double>(v.y));
    CHECK(above < 1);
    longest = std::max(longest, static_cast<double>(v.y));
  }
  CHECK(longest > 195);
  // A rail has 2 triangles a metre and side; a post of 8 sides 16 every 4 m.
  const double metres = 2 * plan.sections()[0].points.back().s;
  CHECK(static_cast<double>(world.fixed.triangles.size()) ==
        Approx(metres * (2 + 16 / 4.0)).epsilon(0.02));
}
