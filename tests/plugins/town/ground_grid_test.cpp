// SPDX-License-Identifier: BSD-3-Clause
// Interpolation is exact for bilinear functions; distances to polylines against brute force.
#include "ground_grid.hpp"

#include <catch2/catch.hpp>

#include "street_grids.hpp"
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

TEST_CASE("a grid of one point has its value everywhere, an empty one has 0") {
  const GroundGrid one({3, 4}, {3, 4}, 1, 7);
  CHECK(one.columns() == 1);
  CHECK(one.at(3, 4) == 7);
  CHECK(one.at(-100, 100) == 7);
  CHECK(GroundGrid().at(1, 2) == 0);
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

TEST_CASE("a very large town gets larger cells instead of more memory") {
  const std::vector<PathPoint> path(2);
  const GroundGrid grid = distanceGrid(path, {{-6000, -6000}, {6000, 6000}}, 60);
  CHECK(grid.cell() > 0.5);
  CHECK(static_cast<double>(grid.columns()) * grid.rows() < 17e6);
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
