// SPDX-License-Identifier: BSD-3-Clause
#include "base/shortest_path.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <limits>
#include <string>

namespace tolman::planning {
namespace {

struct Cost {
  double seconds;
  double metres;
};
using Graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Cost>;

double lengthOf(const Link& link) { return link.T_from_to.translation().norm(); }

/// Mean speed over all links with a duration, m/s; 1 without such links.
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

bool hasDurations(const MapGraph& graph) {
  return std::ranges::any_of(graph.links, [](const Link& link) { return link.duration > 0; });
}

/// The graph without rejected links and without links of infinite length or duration, which a
/// damaged record may contain.
Graph passable(const MapGraph& graph) {
  const double speed = meanSpeed(graph);
  Graph links(graph.experiences.size());
  for (const Link& link : graph.links) {
    const double metres = lengthOf(link);
    const double seconds = link.duration > 0 ? link.duration : metres / speed;
    if (graph.isRejected(link) || !std::isfinite(metres) || !std::isfinite(seconds)) continue;
    const auto from = static_cast<std::size_t>(link.from);
    const auto to = static_cast<std::size_t>(link.to);
    add_edge(from, to, Cost{seconds, metres}, links);
  }
  return links;
}

/// Records the predecessor of each experience during the search, and the length of its path.
struct PathRecorder : boost::default_dijkstra_visitor {
  std::vector<std::size_t>& before;
  std::vector<double>& metres;

  void edge_relaxed(const Graph::edge_descriptor& edge, const Graph& graph) {
    const std::size_t here = target(edge, graph);
    before[here] = source(edge, graph);
    metres[here] = metres[before[here]] + graph[edge].metres;
  }
};

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
  const Graph links = passable(graph);
  std::vector<double> seconds(num_vertices(links));
  std::vector<double> metres(num_vertices(links), 0);
  std::vector<std::size_t> before(num_vertices(links), start);
  boost::dijkstra_shortest_paths(links, start,
                                 boost::weight_map(get(&Cost::seconds, links))
                                     .distance_map(seconds.data())
                                     .visitor(PathRecorder{{}, before, metres}));
  if (seconds[goal] == std::numeric_limits<double>::max()) {
    return Status::failed("no route leads from experience " + std::to_string(from) + " to " +
                          std::to_string(to) +
                          ": they lie in different connected parts of the map");
  }
  PlannedRoute route;
  for (std::size_t here = goal;; here = before[here]) {
    route.legs.push_back({static_cast<std::int64_t>(here), seconds[here], metres[here]});
    if (here == start) break;
  }
  std::reverse(route.legs.begin(), route.legs.end());
  route.times_known = route.legs.size() == 1 || hasDurations(graph);
  return route;
}

MapGraph connectedTo(MapGraph graph, std::int64_t here) {
  if (here < 0 || here >= static_cast<std::int64_t>(graph.experiences.size())) return graph;
  std::vector<std::size_t> part(graph.experiences.size());
  boost::connected_components(passable(graph), part.data());
  const std::size_t own = part[static_cast<std::size_t>(here)];
  std::erase_if(graph.experiences, [&](const Experience& experience) {
    return part[static_cast<std::size_t>(experience.id)] != own;
  });
  return graph;
}

Eigen::Vector3d placeOf(const Experience& experience) {
  const Eigen::Vector3d p = experience.T_world_experience.translation();
  return {p.x(), p.z(), 0 - p.y()};  // 0, not -0, on the ground
}

std::int64_t nearestExperience(const MapGraph& graph, const Eigen::Vector3d& place) {
  const int dimensions = std::isnan(place.z()) ? 2 : 3;
  const auto distance = [&](const Experience& experience) {
    return (placeOf(experience) - place).head(dimensions).squaredNorm();
  };
  const auto nearest = std::min_element(
      graph.experiences.begin(), graph.experiences.end(),
      [&](const Experience& a, const Experience& b) { return distance(a) < distance(b); });
  return nearest == graph.experiences.end() ? -1 : nearest->id;
}

}  // namespace tolman::planning
