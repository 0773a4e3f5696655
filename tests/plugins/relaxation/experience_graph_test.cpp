// SPDX-License-Identifier: BSD-3-Clause
// Links and relaxation on small graphs, compared with values by hand.
#include "experience_graph.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tolman;
using namespace tolman::relaxation;

namespace {

/// Disagreement of all links, m^2 + rad^2.
double strain(const ExperienceGraph& graph) {
  double sum = 0;
  for (const PolarLink& link : graph.links()) {
    const PlanarPose seen = between(graph[link.from], graph[link.to]);
    const PlanarPose said = relaxation::toPlanar(link);
    sum += std::pow(seen.x - said.x, 2) + std::pow(seen.y - said.y, 2) +
           std::pow(wrapAngle(seen.theta - said.theta), 2);
  }
  return sum;
}

/// A square of 4 * side steps that odometry sees too wide, closed by a last link.
ExperienceGraph square(int side, double drift) {
  ExperienceGraph graph;
  PlanarPose pose;
  graph.add(pose);
  for (int k = 1; k < 4 * side; ++k) {
    const PlanarPose step = {1, 0, (k % side == 0 ? std::numbers::pi / 2 : 0) + drift};
    pose = compose(pose, step);
    graph.add(pose);
    graph.link(k - 1, k, step, 1, k, false);
  }
  graph.link(4 * side - 1, 0, {1, 0, std::numbers::pi / 2}, 1, 4 * side, true);
  return graph;
}

}  // namespace

TEST_CASE("a link keeps what was measured in polar form") {
  ExperienceGraph graph;
  graph.add({});
  graph.add({});
  REQUIRE(graph.link(0, 1, {3, -4, 0.7}, 2.5, 9, false));
  const PolarLink& link = graph.links().front();
  CHECK(link.distance == Approx(5));
  CHECK(link.heading == Approx(std::atan2(-4.0, 3.0)));
  CHECK(link.facing == Approx(0.7));
  CHECK(link.seconds == 2.5);
  const PlanarPose back = relaxation::toPlanar(link);
  CHECK(back.x == Approx(3));
  CHECK(back.y == Approx(-4));
}

TEST_CASE("a second link between the same two is refused, either way round (defect 4)") {
  // The original counts the links of one experience and reads those of another.
  ExperienceGraph graph;
  for (int i = 0; i < 4; ++i) graph.add({});
  CHECK(graph.link(0, 1, {1, 0, 0}, 1, 1, false));
  CHECK(graph.link(0, 2, {1, 0, 0}, 1, 2, false));
  CHECK(graph.link(0, 3, {1, 0, 0}, 1, 3, false));
  CHECK_FALSE(graph.link(0, 3, {2, 0, 0}, 1, 4, true));
  CHECK_FALSE(graph.link(3, 0, {2, 0, 0}, 1, 5, true));
  CHECK_FALSE(graph.link(2, 2, {2, 0, 0}, 1, 6, true));
  CHECK(graph.link(3, 1, {2, 0, 0}, 1, 7, true));
  CHECK(graph.links().size() == 4);
}

TEST_CASE("one link relaxes at once, both ends by half") {
  ExperienceGraph graph;
  graph.add({0, 0, 0});
  graph.add({4, 0, 0.2});
  graph.link(0, 1, {2, 0, 0}, 1, 1, false);
  graph.relax(1, 0.5);
  CHECK(graph[0].x == Approx(1));
  CHECK(graph[1].x == Approx(3));
  CHECK(graph[0].theta == Approx(0.1));
  CHECK(graph[1].theta == Approx(0.1));
}

TEST_CASE("relaxation without loops changes nothing") {
  ExperienceGraph graph;
  PlanarPose pose;
  graph.add(pose);
  for (int k = 1; k < 50; ++k) {
    const PlanarPose step = {1, 0.1, 0.05};
    pose = compose(pose, step);
    graph.add(pose);
    graph.link(k - 1, k, step, 1, k, false);
  }
  graph.relax(100, 0.5);
  CHECK(graph[49].x == Approx(pose.x));
  CHECK(graph[49].theta == Approx(pose.theta));
}

TEST_CASE("a loop's disagreement is spread over the whole ring") {
  ExperienceGraph graph = square(10, 0.01);
  const double before = strain(graph);
  graph.relax(20, 0.5);
  const double soon = strain(graph);
  graph.relax(2000, 0.5);
  CHECK(soon < 0.2 * before);
  CHECK(strain(graph) < soon);
  const PlanarPose gap = between(graph[39], graph[0]);
  CHECK(std::hypot(gap.x - 1, gap.y) < 0.2);
}

TEST_CASE("heights relax as x and y do, and by themselves") {
  ExperienceGraph graph;
  graph.add({0, 0, 0}, 0);
  graph.add({2, 0, 0}, 5);
  graph.link(0, 1, {2, 0, 0}, 1, 1, false, 1);
  graph.relax(1, 0.5);
  CHECK(graph.height(0) == Approx(2));
  CHECK(graph.height(1) == Approx(3));
  CHECK(graph[1].x == Approx(2));
}
