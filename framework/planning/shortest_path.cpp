// SPDX-License-Identifier: BSD-3-Clause
#include "planning/shortest_path.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <tuple>

namespace tolman::planning {
namespace {

struct Edge {
  std::size_t to;
  double seconds;
  double metres;
};
using AdjacencyList = std::vector<std::vector<Edge>>;

double lengthOf(const Link& link) { return link.T_from_to.translation().norm(); }

/// m/s over all links with a duration; 1 where there are none.
double meanSpeed(const MapGraph& graph) {
  double metres = 0;
  double seconds = 0;
  for (const Link& link : graph.links) {
    if (!(link.duration > 0)) continue;
    metres += lengthOf(link);
    seconds += link.duration;
  }
  return metres > 0 && seconds > 0 ? metres / seconds : 1;
}

/// Skips rejected links, and those whose length or duration a damaged record has made infinite.
AdjacencyList adjacencyOf(const MapGraph& graph) {
  const double speed = meanSpeed(graph);
  AdjacencyList edges(graph.experiences.size());
  for (const Link& link : graph.links) {
    const double metres = lengthOf(link);
    const double seconds = link.duration > 0 ? link.duration : metres / speed;
    if (graph.isRejected(link) || !std::isfinite(metres) || !std::isfinite(seconds)) continue;
    const auto from = static_cast<std::size_t>(link.from);
    const auto to = static_cast<std::size_t>(link.to);
    edges.at(from).push_back({to, seconds, metres});
    edges.at(to).push_back({from, seconds, metres});
  }
  return edges;
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

struct ShortestPathTree {
  explicit ShortestPathTree(std::size_t size)
      : seconds(size, std::numeric_limits<double>::infinity()),
        metres(size, 0),
        before(size, kNone) {}
  std::vector<double> seconds;
  std::vector<double> metres;
  std::vector<std::size_t> before;
};

ShortestPathTree dijkstra(const AdjacencyList& edges, std::size_t from, std::size_t to) {
  ShortestPathTree tree(edges.size());
  using Candidate = std::tuple<double, std::size_t>;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
  tree.seconds[from] = 0;
  open.emplace(0, from);
  while (!open.empty()) {
    const auto [seconds, here] = open.top();
    open.pop();
    if (here == to) break;
    if (seconds > tree.seconds[here]) continue;  // a faster path was found since
    for (const Edge& edge : edges[here]) {
      const double arrival = seconds + edge.seconds;
      if (arrival >= tree.seconds[edge.to]) continue;
      tree.seconds[edge.to] = arrival;
      tree.metres[edge.to] = tree.metres[here] + edge.metres;
      tree.before[edge.to] = here;
      open.emplace(arrival, edge.to);
    }
  }
  return tree;
}

}  // namespace

Result<PlannedRoute> fastestRoute(const MapGraph& graph, std::int64_t from, std::int64_t to) {
  const auto count = static_cast<std::int64_t>(graph.experiences.size());
  for (const std::int64_t end : {from, to}) {
    if (end >= 0 && end < count) continue;
    return Status::invalidInput("there is no experience " + std::to_string(end) +
                                (count == 0 ? std::string("; the map is empty")
                                            : "; the map has 0 to " + std::to_string(count - 1)));
  }
  const auto start = static_cast<std::size_t>(from);
  const auto goal = static_cast<std::size_t>(to);
  const ShortestPathTree tree = dijkstra(adjacencyOf(graph), start, goal);
  if (goal != start && tree.before[goal] == kNone) {
    return Status::invalidInput("no route leads from experience " + std::to_string(from) + " to " +
                                std::to_string(to) +
                                ": they lie in different connected parts of the map");
  }
  PlannedRoute route;
  for (std::size_t here = goal;; here = tree.before[here]) {
    route.legs.push_back({static_cast<std::int64_t>(here), tree.seconds[here], tree.metres[here]});
    if (here == start) break;
  }
  std::reverse(route.legs.begin(), route.legs.end());
  return route;
}

std::int64_t nearestExperience(const MapGraph& graph, const Eigen::Vector2d& position) {
  const auto distance = [&](const Experience& experience) {
    const Eigen::Vector3d p = experience.T_world_experience.translation();
    return (Eigen::Vector2d(p.x(), p.z()) - position).squaredNorm();
  };
  const auto nearest = std::min_element(
      graph.experiences.begin(), graph.experiences.end(),
      [&](const Experience& a, const Experience& b) { return distance(a) < distance(b); });
  return nearest == graph.experiences.end() ? -1 : nearest->id;
}

}  // namespace tolman::planning
