// SPDX-License-Identifier: BSD-3-Clause
// Houses: walls on the plot's edges that face outwards, storeys, and roofs without a hole.
#include "house.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman;
using namespace tolman::town;

namespace {

constexpr double kGround = 31;

House houseOf(RoofShape roof, int storeys, std::uint32_t seed) {
  RandomStream random(seed);
  const double angle = random.uniform(0, 6.28);
  House house;
  house.plot = {{random.uniform(-50, 50), random.uniform(-50, 50)},
                {std::cos(angle), std::sin(angle)},
                random.uniform(3, 12),
                random.uniform(3, 7)};
  house.ground = kGround;
  house.storeys = storeys;
  house.roof = roof;
  house.seed = seed;
  return house;
}

World built(const House& house) {
  World world;
  addHouse(world, house);
  return world;
}

Eigen::Vector3d corner(const World& world, std::size_t triangle, std::size_t k) {
  const Mesh::Vertex& v = world.fixed.vertices[world.fixed.triangles[triangle][k]];
  return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

Eigen::Vector3d normal(const World& world, std::size_t triangle) {
  const Eigen::Vector3d a = corner(world, triangle, 0);
  return (corner(world, triangle, 1) - a).cross(corner(world, triangle, 2) - a).normalized();
}

Material materialOf(const World& world, std::size_t triangle) {
  return world.surfaces[world.fixed.surfaces[triangle]].material;
}

/// Z of the highest triangle above (x, y), or -infinity: brute force over the whole house.
double roofAbove(const World& world, const Eigen::Vector2d& place) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < world.fixed.triangles.size(); ++i) {
    const Eigen::Vector3d a = corner(world, i, 0);
    Eigen::Matrix2d edges;
    edges << (corner(world, i, 1) - a).head<2>(), (corner(world, i, 2) - a).head<2>();
    if (std::abs(edges.determinant()) < 1e-3) continue;  // a wall
    const Eigen::Vector2d share = edges.inverse() * (place - a.head<2>());
    if (share.minCoeff() < -1e-4 || share.sum() > 1 + 1e-4) continue;
    highest = std::max(highest, a.z() + share[0] * (corner(world, i, 1) - a).z() +
                                    share[1] * (corner(world, i, 2) - a).z());
  }
  return highest;
}

constexpr std::array<RoofShape, 3> kRoofs = {RoofShape::AlongStreet, RoofShape::ToStreet,
                                             RoofShape::Flat};

}  // namespace

TEST_CASE("four walls stand on the edges of the plot and face outwards") {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const House house = houseOf(kRoofs[seed % 3], 2, seed);
    const World world = built(house);
    std::vector<double> widths;
    for (const Surface& surface : world.surfaces) {
      if (surface.material != Material::Facade) continue;
      widths.push_back(static_cast<double>(surface.width));
      CHECK(norm(surface.axis_u) == Approx(1).margin(1e-5));
      CHECK(surface.axis_u.z == 0);
      CHECK(surface.seed == house.seed);
    }
    std::sort(widths.begin(), widths.end());
    REQUIRE(widths.size() == 4);
    const auto [shorter, longer] = std::minmax(house.plot.half_length, house.plot.half_depth);
    CHECK(widths[0] == Approx(2 * shorter).epsilon(1e-4));
    CHECK(widths[1] == Approx(2 * shorter).epsilon(1e-4));
    CHECK(widths[3] == Approx(2 * longer).epsilon(1e-4));
    for (std::size_t i = 0; i < world.fixed.triangles.size(); ++i) {
      if (materialOf(world, i) != Material::Facade) continue;
      const Eigen::Vector2d out = corner(world, i, 0).head<2>() - house.plot.centre;
      REQUIRE(normal(world, i).head<2>().dot(out) > 1);
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector2d d = corner(world, i, k).head<2>() - house.plot.centre;
        REQUIRE(std::abs(d.dot(house.plot.axis)) < house.plot.half_length + 1e-3);
        REQUIRE(std::abs(d.dot(house.plot.across())) < house.plot.half_depth + 1e-3);
      }
    }
  }
}

TEST_CASE("walls reach below ground, so that no gap shows on a slope") {
  const World world = built(houseOf(RoofShape::AlongStreet, 1, 4));
  double lowest = kGround;
  for (const Mesh::Vertex& v : world.fixed.vertices) {
    lowest = std::min(lowest, static_cast<double>(v.z));
  }
  CHECK(lowest < kGround - 1.5);
}

TEST_CASE("each storey lifts the whole roof by the same height") {
  for (const RoofShape shape : kRoofs) {
    std::vector<double> heights;
    for (int storeys = 1; storeys <= 5; ++storeys) {
      const House house = houseOf(shape, storeys, 12);
      heights.push_back(roofAbove(built(house), house.plot.centre));
    }
    const double storey = heights[1] - heights[0];
    CHECK(storey > 2.5);
    CHECK(storey < 3.5);
    for (std::size_t i = 2; i < heights.size(); ++i) {
      CHECK(heights[i] - heights[i - 1] == Approx(storey).margin(1e-3));
    }
  }
}

TEST_CASE("no place of the plot is open to the sky, under any roof") {
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    const House house = houseOf(kRoofs[seed % 3], 2, seed);
    const World world = built(house);
    const double eaves = kGround + 2 * 2.9;
    for (double u = -0.97; u < 1; u += 0.194) {
      for (double v = -0.97; v < 1; v += 0.194) {
        const Eigen::Vector2d place =
            house.plot.point(u * house.plot.half_length, v * house.plot.half_depth);
        CAPTURE(seed, u, v);
        REQUIRE(roofAbove(world, place) > eaves);
      }
    }
  }
}

TEST_CASE("the ridge runs along the street or towards it, as asked") {
  for (const RoofShape shape : {RoofShape::AlongStreet, RoofShape::ToStreet}) {
    const House house = houseOf(shape, 2, 17);
    const World world = built(house);
    std::vector<Eigen::Vector3d> slopes;
    for (std::size_t i = 0; i < world.fixed.triangles.size(); ++i) {
      if (materialOf(world, i) == Material::Roof) slopes.push_back(normal(world, i));
    }
    REQUIRE(slopes.size() == 4);  // two quads
    const Eigen::Vector2d ridge =
        shape == RoofShape::AlongStreet ? house.plot.axis : house.plot.across();
    for (const Eigen::Vector3d& n : slopes) {
      CHECK(std::abs(n.head<2>().dot(ridge)) < 1e-4);
      CHECK(n.head<2>().norm() > 0.4);  // 0.6 to 1.1 of rise a metre
      CHECK(n.head<2>().norm() < 0.75);
    }
  }
}

TEST_CASE("a seed makes one house") {
  const auto tones = [](std::uint32_t seed) {
    House house = houseOf(RoofShape::AlongStreet, 2, 5);
    house.seed = seed;
    std::vector<float> all;
    for (const Surface& surface : built(house).surfaces) all.push_back(surface.tone);
    return all;
  };
  CHECK(tones(5) == tones(5));
  CHECK(tones(5) != tones(6));
}
