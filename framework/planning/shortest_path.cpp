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

struct Step {
  std::size_t to;
  double seconds;
  double metres;
};
using Network = std::vector<std::vector<Step>>;

double lengthOf(const Link& link) { return link.T_from_to.translation().norm(); }

/// m/s over all links that took time; 1 where none did.
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

/// Links lead both ways. Those that a damaged record has made endless lead nowhere.
Network networkOf(const MapGraph& graph) {
  const double speed = meanSpeed(graph);
  Network network(graph.experiences.size());
  for (const Link& link : graph.links) {
    const double metres = lengthOf(link);
    const double seconds = link.duration > 0 ? link.duration : metres / speed;
    if (!link.isBelieved() || !std::isfinite(metres) || !std::isfinite(seconds)) continue;
    const auto from = static_cast<std::size_t>(link.from);
    const auto to = static_cast<std::size_t>(link.to);
    network.at(from).push_back({to, seconds, metres});
    network.at(to).push_back({from, seconds, metres});
  }
  return network;
}

constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

struct Search {
  explicit Search(std::size_t size)
      : seconds(size, std::numeric_limits<double>::infinity()),
        metres(size, 0),
        before(size, kNobody) {}
  std::vector<double> seconds;
  std::vector<double> metres;
  std::vector<std::size_t> before;
};

Search dijkstra(const Network& network, std::size_t from, std::size_t to) {
  Search search(network.size());
  using Candidate = std::tuple<double, std::size_t>;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
  search.seconds[from] = 0;
  open.emplace(0, from);
  while (!open.empty()) {
    const auto [seconds, here] = open.top();
    open.pop();
    if (here == to) break;
    if (seconds > search.seconds[here]) continue;  // was reached faster since
    for (const Step& step : network[here]) {
      const double arrival = seconds + step.seconds;
      if (arrival >= search.seconds[step.to]) continue;
      search.seconds[step.to] = arrival;
      search.metres[step.to] = search.metres[here] + step.metres;
      search.before[step.to] = here;
      open.emplace(arrival, step.to);
    }
  }
  return search;
}

}  // namespace

Result<Route> fastestRoute(const MapGraph& graph, std::int64_t from, std::int64_t to) {
  const auto count = static_cast<std::int64_t>(graph.experiences.size());
  for (const std::int64_t end : {from, to}) {
    if (end >= 0 && end < count) continue;
    return Status::invalidInput("there is no experience " + std::to_string(end) +
                                "; the map has 0 to " + std::to_string(count - 1));
  }
  const auto start = static_cast<std::size_t>(from);
  const auto goal = static_cast<std::size_t>(to);
  const Search search = dijkstra(networkOf(graph), start, goal);
  if (goal != start && search.before[goal] == kNobody) {
    return Status::invalidInput("no way leads from experience " + std::to_string(from) + " to " +
                                std::to_string(to) +
                                ": they lie in parts of the map that no loop has joined");
  }
  Route route;
  for (std::size_t here = goal;; here = search.before[here]) {
    route.legs.push_back(
        {static_cast<std::int64_t>(here), search.seconds[here], search.metres[here]});
    if (here == start) break;
  }
  std::reverse(route.legs.begin(), route.legs.end());
  return route;
}

std::int64_t nearestExperience(const MapGraph& graph, const Eigen::Vector2d& place) {
  const auto distance = [&](const Experience& experience) {
    const Eigen::Vector3d p = experience.T_world_experience.translation();
    return (Eigen::Vector2d(p.x(), p.z()) - place).squaredNorm();
  };
  const auto nearest = std::min_element(
      graph.experiences.begin(), graph.experiences.end(),
      [&](const Experience& a, const Experience& b) { return distance(a) < distance(b); });
  return nearest == graph.experiences.end() ? -1 : nearest->id;
}

}  // namespace tolman::planning
