// SPDX-License-Identifier: BSD-3-Clause
// Loops and views between places whose distance is known.
#include "evaluation/loop_figures.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// Twice along a street of 100 m, a metre a frame; the second drive is 2 m beside the first.
Trajectory twoDrives() {
  Trajectory truth;
  for (int i = 0; i < 200; ++i) {
    TrajectoryPose pose;
    pose.frame = i;
    pose.T_world_camera.translation() = Eigen::Vector3d(i < 100 ? 0 : 2, 0, i % 100);
    truth.push_back(pose);
  }
  return truth;
}

/// An experience at every tenth frame.
MapGraph graphWith(const std::vector<std::pair<int, int>>& loops) {
  MapGraph graph;
  for (int i = 0; i < 20; ++i) graph.experiences.push_back({i, 10 * i, i, {}});
  for (const auto& [from, to] : loops) {
    Link link;
    link.id = static_cast<std::int64_t>(graph.links.size());
    link.from = from;
    link.to = to;
    link.kind = LinkKind::Loop;
    link.frame = 10 * from;
    graph.links.push_back(link);
  }
  return graph;
}

PlaceObservation view(std::int64_t frame, std::int64_t id, Recognition recognition) {
  PlaceObservation place;
  place.frame = frame;
  place.template_id = id;
  place.recognition = recognition;
  return place;
}

}  // namespace

TEST_CASE("loop links between near places are true, others false") {
  MapGraph graph = graphWith({{11, 1}, {12, 2}, {13, 2}, {15, 1}});  // 2, 2, 10.2 and 40 m apart
  LoopFigures figures = loopFigures(graph, {}, twoDrives());
  CHECK(figures.true_links == 2);
  CHECK(figures.false_links == 2);
  graph.rejected = {3};
  CHECK(loopFigures(graph, {}, twoDrives()).false_links == 1);
  Trajectory part = twoDrives();
  part.resize(115);  // 12, 13 and 15 have no true pose
  figures = loopFigures(graph, {}, part);
  CHECK(figures.true_links == 1);
  CHECK(figures.false_links == 0);
  CHECK(loopFigures(graph, {}, {}).true_links == 0);
}

TEST_CASE("places of different storeys are different where heights count") {
  Trajectory truth = twoDrives();
  for (TrajectoryPose& pose : truth)
    pose.T_world_camera.translation().y() = pose.frame < 100 ? 0 : -3;
  const MapGraph graph = graphWith({{11, 1}, {12, 2}, {12, 11}});
  CHECK(loopFigures(graph, {}, truth).false_links == 0);
  const std::vector<PlaceObservation> places = {view(10, 0, Recognition::Novel),
                                                view(12, 0, Recognition::Familiar),
                                                view(110, 0, Recognition::Familiar)};
  const LoopFigures figures = loopFigures(graph, places, truth, 1.5);
  CHECK(figures.true_links == 1);  // along the upper storey
  CHECK(figures.false_links == 2);
  CHECK(figures.true_views == 1);
  CHECK(figures.false_views == 1);
  CHECK(loopFigures(graph, places, truth, 3.5).false_links == 0);
}

TEST_CASE("views are judged by where they were learned, and closed near a true loop") {
  std::vector<PlaceObservation> places;
  for (int i = 0; i < 10; ++i) places.push_back(view(10 * i, i, Recognition::Novel));
  places.push_back(view(112, 1, Recognition::Familiar));  // 2 m driven from the loop at 110
  places.push_back(view(116, 2, Recognition::Familiar));  // 6 m
  places.push_back(view(120, 9, Recognition::Familiar));  // 70 m from the place
  places.push_back(view(121, 7, Recognition::None));
  const LoopFigures figures = loopFigures(graphWith({{11, 1}, {15, 1}}), places, twoDrives());
  CHECK(figures.true_views == 2);
  CHECK(figures.false_views == 1);
  CHECK(figures.true_views_closed == 1);
  CHECK(toJson(figures)["true_views_closed"] == 1);
}

TEST_CASE("links and views to where there is no truth are unknown") {
  Trajectory own = twoDrives();
  own.erase(own.begin(), own.begin() + 100);  // the second session
  const LoopFigures figures =
      loopFigures(graphWith({{11, 1}, {15, 5}, {19, 10}}),
                  {view(10, 0, Recognition::Novel), view(110, 0, Recognition::Familiar),
                   view(120, 7, Recognition::Familiar), view(130, 1, Recognition::Novel),
                   view(132, 1, Recognition::Familiar)},
                  own);
  CHECK(figures.unknown_links == 2);
  CHECK(figures.true_links == 0);
  CHECK(figures.false_links == 1);
  CHECK(figures.unknown_views == 2);  // one of an earlier session, one learned nowhere
  CHECK(figures.true_views == 1);
  CHECK(toJson(figures)["unknown_views"] == 2);
}
