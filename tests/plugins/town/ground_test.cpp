// SPDX-License-Identifier: BSD-3-Clause
// Grids over the ground, and the ground as a surface: without gaps, facing up, with the kerb of the
// plan.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "drawn_route.hpp"
#include "ground_grid.hpp"
#include "objects.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

/// Oracle: the nearest of 400 points of every piece.
double sampledDistance(const std::vector<PathPoint>& path, const Eigen::Vector2d& place) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    for (int k = 0; k <= 400; ++k) {
      const Eigen::Vector2d p =
          path[i].centre + (path[i + 1].centre - path[i].centre) * (k / 400.0);
      nearest = std::min(nearest, (p - place).norm());
    }
  }
  return nearest;
}

}  // namespace

TEST_CASE("a bilinear function is interpolated exactly, and goes on level beyond the edge") {
  RandomStream random(4);
  for (int round = 0; round < 50; ++round) {
    const Eigen::Vector2d low(random.uniform(-90, 0), random.uniform(-90, 0));
    const Eigen::Vector2d high =
        low + Eigen::Vector2d(random.uniform(3, 40), random.uniform(3, 40));
    GroundGrid grid(low, high, random.uniform(0.3, 2), 0);
    const double a = random.uniform(-1, 1);
    const double b = random.uniform(-1, 1);
    const double c = random.uniform(-0.1, 0.1);
    const auto f = [&](const Eigen::Vector2d& p) { return a * p.x() + b * p.y() + c * p.prod(); };
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        grid.value(column, row) = static_cast<float>(f(grid.position(column, row)));
      }
    }
    const Eigen::Vector2d last = grid.position(grid.columns() - 1, grid.rows() - 1);
    REQUIRE((last - high).minCoeff() > -1e-9);  // the grid covers what was asked for
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector2d p(random.uniform(low.x() - 9, high.x() + 9),
                              random.uniform(low.y() - 9, high.y() + 9));
      const Eigen::Vector2d inside = p.cwiseMax(low).cwiseMin(last);
      REQUIRE(grid.at(p.x(), p.y()) == Approx(f(inside)).margin(2e-3));
    }
  }
}

TEST_CASE("distances are those to the polyline at every point of the grid, cut off far away") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    RandomStream random(seed);
    std::vector<PathPoint> path(6);
    for (PathPoint& point : path) {
      point.centre = {random.uniform(-40, 40), random.uniform(-40, 40)};
    }
    path[3].centre = path[2].centre;  // a piece without length
    const GroundGrid grid = distanceGrid(path, {{-60, -55}, {58, 61}}, 25);
    CHECK(grid.cell() == 0.5);
    int far = 0;
    for (int row = 0; row < grid.rows(); row += 7) {
      for (int column = 0; column < grid.columns(); column += 7) {
        const double expected = std::min(25.0, sampledDistance(path, grid.position(column, row)));
        REQUIRE(static_cast<double>(grid.value(column, row)) == Approx(expected).margin(0.15));
        REQUIRE(static_cast<double>(grid.value(column, row)) < expected + 1e-4);
        far += expected == 25.0;
      }
    }
    CHECK(far > 10);
  }
}

TEST_CASE("heights that no pass contradicts stay as they were driven") {
  RandomStream random(6);
  std::vector<PathPoint> path(300);
  for (std::size_t i = 0; i < path.size(); ++i) {
    path[i].s = static_cast<double>(i);
    path[i].driven = {0, path[i].s};
    path[i].height = random.uniform(-3, 3);
  }
  const std::vector<double> heights = agreeOnHeights(path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    REQUIRE(heights[i] == Approx(path[i].height).margin(1e-9));
  }
}

TEST_CASE("two passes at different heights take the mean, which fades out along the street") {
  // Out for 400 m, and at last 60 m back beside it, 1 m higher.
  std::vector<PathPoint> path;
  for (int i = 0; i < 460; ++i) {
    PathPoint point;
    point.s = i;
    const bool back = i >= 400;
    point.driven = back ? Eigen::Vector2d(1, 459 - i) : Eigen::Vector2d(0, i);
    point.direction = {0, back ? -1 : 1};
    point.height = back ? 1 : 0;
    path.push_back(point);
  }
  const std::vector<double> heights = agreeOnHeights(path);
  for (std::size_t out = 5; out < 50; out += 5) {
    CHECK(heights[out] == Approx(heights[459 - out]).margin(0.03));
    CHECK(heights[out] == Approx(0.5).margin(0.12));
  }
  // Beyond the meeting the correction falls off like exp(-distance / 15 m).
  for (std::size_t i = 75; i < 120; i += 5) {
    CHECK(heights[i + 15] / heights[i] == Approx(std::exp(-1)).epsilon(0.05));
  }
  CHECK(std::abs(heights[250]) < 1e-4);
}

namespace tolman::town::test {
namespace {

constexpr GroundSurfaces kSurfaces{10, 11, 12};
constexpr double kHalf = StreetPlan::kRoadHalfWidth;

struct Town {
  StreetPlan plan;
  Mesh mesh;
  Mesh without_skirt;  // what comes first in mesh: the skirt is apart from it
};

/// Triangles from the first that uses a vertex of the skirt's grid are left out.
Mesh fineGround(const Mesh& mesh, const Mesh& skirt_only_differs) {
  Mesh fine = mesh;
  std::size_t same = 0;
  const std::size_t most = std::min(mesh.vertices.size(), skirt_only_differs.vertices.size());
  while (same < most && mesh.vertices[same].x == skirt_only_differs.vertices[same].x &&
         mesh.vertices[same].y == skirt_only_differs.vertices[same].y) {
    ++same;
  }
  fine.triangles.clear();
  fine.surfaces.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Mesh::Triangle& t = mesh.triangles[i];
    if (*std::max_element(t.begin(), t.end()) >= same) break;
    fine.triangles.push_back(t);
    fine.surfaces.push_back(mesh.surfaces[i]);
  }
  fine.vertices.resize(same);
  return fine;
}

Town townOf(const CameraRoute& route) {
  Town town{StreetPlan::grow(route, 1.65).value(), {}, {}};
  town.mesh = buildGround(town.plan, kSurfaces);
  town.without_skirt = fineGround(town.mesh, buildGround(town.plan, kSurfaces, 407));
  return town;
}

CameraRoute straightRoute() {
  LanePath path(StreetPlan::kLaneOffset);
  path.ahead(100);
  return drawnRoute(path);
}

Eigen::Vector3d corner(const Mesh& mesh, std::size_t triangle, std::size_t i) {
  const Mesh::Vertex& v = mesh.vertices[mesh.triangles[triangle][i]];
  return {v.x, v.y, v.z};
}

/// Twice the area, along the normal.
Eigen::Vector3d normal(const Mesh& mesh, std::size_t triangle) {
  const Eigen::Vector3d a = corner(mesh, triangle, 0);
  return (corner(mesh, triangle, 1) - a).cross(corner(mesh, triangle, 2) - a);
}

/// m^2 seen from above.
double areaOf(const Mesh& mesh, std::uint32_t surface) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.surfaces[i] == surface) area += normal(mesh, i).z() / 2;
  }
  return area;
}

}  // namespace

TEST_CASE("every edge of the ground is shared by two triangles that run along it oppositely",
          "[figures]") {
  for (const char* name : {"block", "eights", "district"}) {
    const Town town = townOf(builtIn(name));
    const Mesh& mesh = town.without_skirt;
    REQUIRE(mesh.triangles.size() > 50'000);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Mesh::Triangle& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) REQUIRE(++edges[{t[i], t[(i + 1) % 3]}] == 1);
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
      if (edges.contains({edge.second, edge.first})) continue;
      ++open;  // only where the fine ground ends
      const Mesh::Vertex& v = mesh.vertices[edge.first];
      REQUIRE(town.plan.distance(v.x, v.y) > StreetPlan::kFarthest - 2);
    }
    CHECK(open > 500);
    CHECK(open < edges.size() / 50);
  }
}

TEST_CASE("road and land face up, kerbs stand upright and face the road", "[figures]") {
  const Town town = townOf(builtIn("district"));
  const Mesh& mesh = town.mesh;
  std::size_t kerbs = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Eigen::Vector3d n = normal(mesh, i);
    REQUIRE(n.norm() > 1e-6);
    if (mesh.surfaces[i] != kSurfaces.kerb) {
      REQUIRE(n.z() > 0);
      continue;
    }
    ++kerbs;
    REQUIRE(std::abs(n.z()) < 1e-3 * n.norm());
    const Eigen::Vector3d middle =
        (corner(mesh, i, 0) + corner(mesh, i, 1) + corner(mesh, i, 2)) / 3;
    const Eigen::Vector3d before = middle + 0.3 * n.normalized();
    const Eigen::Vector3d behind = middle - 0.3 * n.normalized();
    REQUIRE(town.plan.distance(before.x(), before.y()) <
            town.plan.distance(behind.x(), behind.y()));
  }
  CHECK(kerbs > 2000);
}

TEST_CASE("the road lies at the plan's height, land a kerb higher", "[figures]") {
  const Town town = townOf(builtIn("district"));
  const Mesh& mesh = town.without_skirt;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d v = corner(mesh, i, k);
      const double above = v.z() - town.plan.height(v.x(), v.y());
      const double distance = town.plan.distance(v.x(), v.y());
      if (mesh.surfaces[i] == kSurfaces.road) {
        REQUIRE(above == Approx(0).margin(1e-3));
        REQUIRE(distance < kHalf + 0.05);
      } else if (mesh.surfaces[i] == kSurfaces.land) {
        REQUIRE(above == Approx(StreetPlan::kKerbHeight).margin(1e-3));
        REQUIRE(distance > kHalf - 0.05);
      } else {
        REQUIRE(distance == Approx(kHalf).margin(0.05));
      }
    }
  }
}

TEST_CASE("the kerb of a straight street is a stadium") {
  const Town town = townOf(straightRoute());
  const double length = 100 + 2 * 50;
  CHECK(areaOf(town.mesh, kSurfaces.road) ==
        Approx(2 * kHalf * length + std::numbers::pi * kHalf * kHalf).epsilon(0.002));
  double kerb_area = 0;
  for (std::size_t i = 0; i < town.mesh.triangles.size(); ++i) {
    if (town.mesh.surfaces[i] == kSurfaces.kerb) kerb_area += normal(town.mesh, i).norm() / 2;
  }
  const double perimeter = 2 * length + 2 * std::numbers::pi * kHalf;
  CHECK(kerb_area == Approx(perimeter * StreetPlan::kKerbHeight).epsilon(0.01));
}

TEST_CASE("fine land reaches kFarthest, the skirt to the horizon, a little lower") {
  const Town town = townOf(straightRoute());
  const double far = StreetPlan::kFarthest;
  const double fine =
      areaOf(town.without_skirt, kSurfaces.road) + areaOf(town.without_skirt, kSurfaces.land);
  CHECK(fine == Approx(2 * far * 200 + std::numbers::pi * far * far).epsilon(0.02));
  const std::size_t first = town.without_skirt.vertices.size();
  float low_x = 0;
  float high_x = 0;
  for (std::size_t i = first; i < town.mesh.vertices.size(); ++i) {
    const Mesh::Vertex& v = town.mesh.vertices[i];
    low_x = std::min(low_x, v.x);
    high_x = std::max(high_x, v.x);
    REQUIRE(v.z < town.plan.height(v.x, v.y) + StreetPlan::kKerbHeight - 0.2);
  }
  CHECK(low_x == Approx(town.plan.lowCorner().x() - 400).margin(0.1));
  CHECK(high_x >= town.plan.highCorner().x() + 400);
}

TEST_CASE("the skirt leaves no gap around the fine ground and none of it shows through") {
  const Town town = townOf(builtIn("block"));
  const std::size_t first = town.without_skirt.vertices.size();
  double covered = 0;
  for (std::size_t i = town.without_skirt.triangles.size(); i < town.mesh.triangles.size(); ++i) {
    REQUIRE(town.mesh.triangles[i][0] >= first);
    covered += normal(town.mesh, i).z() / 2;
    for (double u = 0.1; u < 1; u += 0.2) {
      for (double w = 0.05; u + w < 1; w += 0.2) {
        const Eigen::Vector3d at = (1 - u - w) * corner(town.mesh, i, 0) +
                                   u * corner(town.mesh, i, 1) + w * corner(town.mesh, i, 2);
        if (town.plan.distance(at.x(), at.y()) > StreetPlan::kFarthest - 1.5) continue;
        REQUIRE(at.z() < town.plan.height(at.x(), at.y()));
      }
    }
  }
  const Eigen::Vector2d size = town.plan.highCorner() - town.plan.lowCorner();
  const double fine =
      areaOf(town.without_skirt, kSurfaces.road) + areaOf(town.without_skirt, kSurfaces.land);
  CHECK(covered + fine > (size.x() + 800) * (size.y() + 800));  // they overlap
}

}  // namespace tolman::town::test
