// SPDX-License-Identifier: BSD-3-Clause
#include "base/shortest_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::planning;

namespace {

MapGraph graphOf(std::int64_t experiences) {
  MapGraph graph;
  for (std::int64_t i = 0; i < experiences; ++i) {
    Experience experience;
    experience.id = i;
    experience.T_world_experience.translation() << static_cast<double>(i), 0, 10;
    graph.experiences.push_back(experience);
  }
  return graph;
}

void connect(MapGraph& graph, std::int64_t from, std::int64_t to, double seconds, double metres,
             LinkKind kind = LinkKind::Odometry) {
  Link link;
  link.id = static_cast<std::int64_t>(graph.links.size());
  link.from = from;
  link.to = to;
  link.kind = kind;
  link.duration = seconds;
  link.T_from_to.translation().z() = metres;
  graph.links.push_back(link);
}

std::vector<std::int64_t> idsOf(const PlannedRoute& route) {
  std::vector<std::int64_t> ids;
  for (const Leg& leg : route.legs) ids.push_back(leg.experience);
  return ids;
}

/// All-pairs times by Floyd and Warshall: another algorithm.
Eigen::MatrixXd allTimes(const MapGraph& graph) {
  const auto n = static_cast<Eigen::Index>(graph.experiences.size());
  Eigen::MatrixXd times = Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::infinity());
  times.diagonal().setZero();
  for (const Link& link : graph.links) {
    times(link.from, link.to) = std::min(times(link.from, link.to), link.duration);
    times(link.to, link.from) = std::min(times(link.to, link.from), link.duration);
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        times(i, j) = std::min(times(i, j), times(i, k) + times(k, j));
      }
    }
  }
  return times;
}

}  // namespace

TEST_CASE("the fastest way is taken, not the shortest, and in both directions") {
  MapGraph graph = graphOf(4);
  connect(graph, 0, 1, 1, 50);
  connect(graph, 1, 3, 1, 50);
  connect(graph, 0, 2, 10, 1);
  connect(graph, 2, 3, 10, 1);
  const auto there = fastestRoute(graph, 0, 3);
  REQUIRE(there.isOk());
  CHECK(idsOf(there.value()) == std::vector<std::int64_t>{0, 1, 3});
  CHECK(there.value().seconds() == 2);
  CHECK(there.value().metres() == 100);
  CHECK(idsOf(fastestRoute(graph, 3, 0).value()) == std::vector<std::int64_t>{3, 1, 0});
}

TEST_CASE("a loop link costs its length at the mean speed") {
  MapGraph graph = graphOf(3);
  connect(graph, 0, 1, 10, 20);  // 2 m/s
  connect(graph, 1, 2, 10, 20);
  connect(graph, 2, 0, 0, 4, LinkKind::Loop);
  const auto route = fastestRoute(graph, 0, 2);
  CHECK(idsOf(route.value()) == std::vector<std::int64_t>{0, 2});
  CHECK(route.value().seconds() == Approx(2));
}

TEST_CASE("without any duration times are not known, and the way is the shortest") {
  MapGraph graph = graphOf(4);
  connect(graph, 0, 1, 0, 5);
  connect(graph, 1, 3, 0, 5);
  connect(graph, 0, 2, 0, 2);
  connect(graph, 2, 3, 0, 2);
  const PlannedRoute route = fastestRoute(graph, 0, 3).value();
  CHECK(idsOf(route) == std::vector<std::int64_t>{0, 2, 3});
  CHECK_FALSE(route.times_known);
  CHECK(fastestRoute(graph, 1, 1).value().times_known);
  connect(graph, 0, 3, 100, 100);
  CHECK(fastestRoute(graph, 0, 3).value().times_known);
}

TEST_CASE("rejected loop links are not used; links of a small weight are") {
  MapGraph graph = graphOf(2);
  connect(graph, 0, 1, 1, 1, LinkKind::Loop);
  graph.rejected = {0};
  CHECK(fastestRoute(graph, 0, 1).status().message() ==
        "no route leads from experience 0 to 1: they lie in different connected parts of the map");
  graph.rejected.clear();
  graph.links[0].weight = 0.01;
  CHECK(fastestRoute(graph, 0, 1).isOk());
}

TEST_CASE("ends that do not exist are named; being there already takes no time") {
  MapGraph graph = graphOf(2);
  CHECK(fastestRoute(graph, 0, 2).status().message() ==
        "there is no experience 2; the map has 0 to 1");
  CHECK(fastestRoute(MapGraph{}, 0, 0).status().message() ==
        "there is no experience 0; the map is empty");
  CHECK_FALSE(fastestRoute(graph, -1, 0).isOk());
  const auto none = fastestRoute(graph, 1, 1);
  REQUIRE(none.isOk());
  CHECK(none.value().legs.size() == 1);
  CHECK(none.value().seconds() == 0);
}

TEST_CASE("times agree with another algorithm on random maps") {
  RandomStream random(4);
  for (int round = 0; round < 20; ++round) {
    MapGraph graph = graphOf(15);
    for (int i = 0; i < 25; ++i) {
      connect(graph, static_cast<std::int64_t>(random.below(15)),
              static_cast<std::int64_t>(random.below(15)), random.uniform(0.1, 5), 1);
    }
    const Eigen::MatrixXd times = allTimes(graph);
    for (std::int64_t from = 0; from < 15; ++from) {
      for (std::int64_t to = 0; to < 15; ++to) {
        const auto route = fastestRoute(graph, from, to);
        REQUIRE(route.isOk() == std::isfinite(times(from, to)));
        if (route.isOk()) CHECK(route.value().seconds() == Approx(times(from, to)));
      }
    }
  }
}

TEST_CASE("a place is the experience nearest to it in the plane") {
  const MapGraph graph = graphOf(5);
  const double any = std::numeric_limits<double>::quiet_NaN();
  CHECK(nearestExperience(graph, {3.4, -100, any}) == 3);
  CHECK(nearestExperience({}, {0, 0, any}) == -1);
}

TEST_CASE("with a height it is the nearest in space, and a route leads over the ramp") {
  MapGraph graph = graphOf(5);  // 0 to 4 along x, linked in a row; 4 lies over 0
  graph.experiences[4].T_world_experience.translation() = Eigen::Vector3d(0, -3, 10);
  const double any = std::numeric_limits<double>::quiet_NaN();
  CHECK(nearestExperience(graph, {0, 10, any}) == 0);
  CHECK(nearestExperience(graph, {0, 10, 2.5}) == 4);
  CHECK(placeOf(graph.experiences[4]).isApprox(Eigen::Vector3d(0, 10, 3)));
  for (std::int64_t i = 0; i < 4; ++i) connect(graph, i, i + 1, 1, 1);
  const auto route = fastestRoute(graph, 0, 4);
  REQUIRE(route.isOk());
  CHECK(route.value().legs.size() == 5);  // no shaft
}

TEST_CASE("only what a route leads to is connected") {
  MapGraph graph = graphOf(5);
  connect(graph, 0, 1, 1, 1);
  connect(graph, 3, 2, 1, 1);
  connect(graph, 1, 2, 1, 1, LinkKind::Loop);
  connect(graph, 3, 4, 1, 1);
  graph.rejected = {2};
  const auto idsFrom = [&](std::int64_t here) {
    std::vector<std::int64_t> ids;
    for (const Experience& experience : connectedTo(graph, here).experiences) {
      ids.push_back(experience.id);
    }
    return ids;
  };
  CHECK(idsFrom(1) == std::vector<std::int64_t>{0, 1});
  CHECK(idsFrom(4) == std::vector<std::int64_t>{2, 3, 4});
  CHECK(idsFrom(-1).size() == 5);
  CHECK(nearestExperience(connectedTo(graph, 0), {4, 10, 0}) == 1);
}

TEST_CASE("an odometry link without a time costs its length at the mean speed of those with one") {
  MapGraph graph = graphOf(4);
  connect(graph, 0, 1, 2, 6);
  connect(graph, 1, 2, 0, 9);  // both ends at one moment, as where a session begins
  connect(graph, 2, 3, 1, 3);
  const auto route = fastestRoute(graph, 0, 3);
  REQUIRE(route.isOk());
  CHECK(route.value().seconds() == Approx(2 + 9 / 3.0 + 1));
  CHECK(route.value().metres() == Approx(18));
}

TEST_CASE("a place on the ground has the height 0, not -0") {
  CHECK_FALSE(std::signbit(placeOf(Experience()).z()));
}
