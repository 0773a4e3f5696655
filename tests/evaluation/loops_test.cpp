// SPDX-License-Identifier: BSD-3-Clause
// Links and views against true places; precision and recall of claims.
#include "evaluation/loops.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tolman/context.hpp"

using namespace tolman::evaluation;
using namespace tolman;

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

LoopFigures figuresOf(const MapGraph& graph, const std::vector<PlaceObservation>& places,
                      const Trajectory& truth, double storey_height = 0) {
  return loopFigures(judgeLoops(graph, places, truth, storey_height), places, truth, storey_height);
}

PlaceClaim claim(double score, bool right) { return {0, 0, score, right}; }

}  // namespace

TEST_CASE("loop links between near places are true, others false") {
  MapGraph graph = graphWith({{11, 1}, {12, 2}, {13, 2}, {15, 1}});  // 2, 2, 10.2 and 40 m apart
  LoopFigures figures = figuresOf(graph, {}, twoDrives());
  CHECK(figures.true_links == 2);
  CHECK(figures.false_links == 2);
  graph.rejected = {3};
  CHECK(figuresOf(graph, {}, twoDrives()).false_links == 1);
  Trajectory part = twoDrives();
  part.resize(115);  // 12, 13 and 15 have no true pose
  figures = figuresOf(graph, {}, part);
  CHECK(figures.true_links == 1);
  CHECK(figures.false_links == 0);
  CHECK(figuresOf(graph, {}, {}).true_links == 0);
}

TEST_CASE("a link with a measured pose is judged by the error of that pose, others by their ends") {
  Trajectory truth = twoDrives();
  truth[0].T_world_camera.linear() =  // the truth has orientations
      Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const MapGraph graph = graphWith({{13, 2}});  // 10.2 m apart
  CHECK(judgeLoops(graph, {}, truth).at(0).is_true == false);
  PlaceObservation seen = view(130, 0, Recognition::Familiar);
  seen.has_relative_pose = true;
  seen.covariance = Matrix6d::Identity() * 0.04;  // 0.2 m
  const auto judged = [&](double forward, double up) {
    seen.T_template_current.translation() = Eigen::Vector3d(2, -up, forward);
    return judgeLoops(graph, {view(20, 0, Recognition::Novel), seen}, truth, 1.5).at(0);
  };
  const JudgedLoop right = judged(10.4, 0);
  CHECK(right.is_true == true);
  CHECK(*right.error_m == Approx(0.4));
  CHECK(*right.error_sigmas == Approx(2));
  CHECK(*right.apart_m == Approx(std::hypot(10, 2)));
  CHECK(right.frame == 130);
  CHECK(right.earlier == 20);
  CHECK(judged(8.5, 0).is_true == false);  // 1.5 m, 7.5 standard deviations
  CHECK(judged(10, 2).is_true == false);   // another storey
  seen.covariance = Matrix6d::Identity();  // it says how uncertain it is
  CHECK(judged(8.5, 0).is_true == true);
  CHECK(judged(-1, 0).is_true == false);  // 11 m
}

TEST_CASE("places of different storeys are different where heights count") {
  Trajectory truth = twoDrives();
  for (TrajectoryPose& pose : truth)
    pose.T_world_camera.translation().y() = pose.frame < 100 ? 0 : -3;
  const MapGraph graph = graphWith({{11, 1}, {12, 2}, {12, 11}});
  CHECK(figuresOf(graph, {}, truth).false_links == 0);
  const std::vector<PlaceObservation> places = {view(10, 0, Recognition::Novel),
                                                view(12, 0, Recognition::Familiar),
                                                view(110, 0, Recognition::Familiar)};
  const LoopFigures figures = figuresOf(graph, places, truth, 1.5);
  CHECK(figures.true_links == 1);  // along the upper storey
  CHECK(figures.false_links == 2);
  CHECK(figures.true_views == 1);
  CHECK(figures.false_views == 1);
  CHECK(figuresOf(graph, places, truth, 3.5).false_links == 0);
}

TEST_CASE("views are judged by where they were learned, and closed near a true loop") {
  std::vector<PlaceObservation> places;
  for (int i = 0; i < 10; ++i) places.push_back(view(10 * i, i, Recognition::Novel));
  places.push_back(view(112, 1, Recognition::Familiar));  // 2 m driven from the loop at 110
  places.push_back(view(116, 2, Recognition::Familiar));  // 6 m
  places.push_back(view(120, 9, Recognition::Familiar));  // 70 m from the place
  places.push_back(view(121, 7, Recognition::None));
  const LoopFigures figures = figuresOf(graphWith({{11, 1}, {15, 1}}), places, twoDrives());
  CHECK(figures.true_views == 2);
  CHECK(figures.false_views == 1);
  CHECK(figures.true_views_closed == 1);
  CHECK(toJson(figures)["true_views_closed"] == 1);
}

TEST_CASE("links and views to where there is no truth are unknown") {
  Trajectory own = twoDrives();
  own.erase(own.begin(), own.begin() + 100);  // the second session
  const LoopFigures figures =
      figuresOf(graphWith({{11, 1}, {15, 5}, {19, 10}}),
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

TEST_CASE("right claims first, then wrong ones: recall rises, then precision falls") {
  std::vector<PlaceClaim> claims;
  for (int i = 0; i < 10; ++i) claims.push_back(claim(0.01 * i, true));
  for (int i = 0; i < 10; ++i) claims.push_back(claim(0.5 + 0.01 * i, false));
  std::reverse(claims.begin(), claims.end());  // their order must not matter
  const auto curve = precisionRecall(claims, 20);
  REQUIRE(curve.size() == 20);
  for (int i = 0; i < 10; ++i) {
    CHECK(curve[std::size_t(i)].precision == 1);
    CHECK(curve[std::size_t(i)].recall == Approx((i + 1) / 20.0));
    CHECK(curve[std::size_t(i) + 10].precision == Approx(10.0 / (11 + i)));
    CHECK(curve[std::size_t(i) + 10].recall == 0.5);
  }
  CHECK(recallAt(curve, 1) == 0.5);
  CHECK(recallAt(curve, 0.5) == 0.5);
}

TEST_CASE("claims with the same score are made together") {
  // Surest first they would have precision 1, surest last 1/2: a threshold cannot tell.
  const auto curve = precisionRecall(
      {claim(0.1, true), claim(0.2, true), claim(0.2, false), claim(0.2, true), claim(0.3, true)},
      4);
  REQUIRE(curve.size() == 3);
  CHECK(curve[0].score == 0.1);
  CHECK(curve[0].claims == 1);
  CHECK(curve[1].score == 0.2);
  CHECK(curve[1].claims == 4);
  CHECK(curve[1].precision == 0.75);
  CHECK(curve[1].recall == 0.75);
  CHECK(curve[2].precision == 0.8);
  CHECK(curve[2].recall == 1);
  CHECK(recallAt(curve, 1) == 0.25);
  CHECK(recallAt(curve, 0.75) == 1);
}

TEST_CASE("recall is the largest that has the precision, even after a dip") {
  std::vector<PlaceClaim> claims = {claim(0, false)};
  for (int i = 1; i < 10; ++i) claims.push_back(claim(i, true));
  const auto curve = precisionRecall(claims, 9);
  CHECK(curve.front().precision == 0);
  CHECK(curve.front().recall == 0);
  CHECK(recallAt(curve, 0.9) == 1);
  CHECK(recallAt(curve, 0.91) == 0);
}

TEST_CASE("no claims, no right ones, nothing to be found") {
  CHECK(precisionRecall({}, 10).empty());
  CHECK(recallAt({}, 1) == 0);
  CHECK(recallAt({}, 0) == 0);
  const auto wrong = precisionRecall({claim(0.1, false), claim(0.2, false)}, 5);
  REQUIRE(wrong.size() == 2);
  CHECK(wrong[1].precision == 0);
  CHECK(recallAt(wrong, 0.01) == 0);
  const auto unfindable = precisionRecall({claim(0.1, false)}, 0);
  REQUIRE(unfindable.size() == 1);
  CHECK(unfindable[0].recall == 0);
}

TEST_CASE("every point is what counting the claims up to its score gives") {
  RandomStream random(6);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<PlaceClaim> claims;
    std::set<double> scores;
    for (int i = 0; i < 200; ++i) {
      const double score = 0.01 * static_cast<double>(random.below(40));
      claims.push_back(claim(score, random.uniform() > score));
      scores.insert(score);
    }
    const auto curve = precisionRecall(claims, 300);
    REQUIRE(curve.size() == scores.size());
    double best = 0;
    for (const PrecisionRecall& point : curve) {
      std::int64_t made = 0;
      std::int64_t right = 0;
      for (const PlaceClaim& c : claims) {
        made += c.score <= point.score ? 1 : 0;
        right += c.score <= point.score && c.right ? 1 : 0;
      }
      REQUIRE(point.claims == made);
      REQUIRE(point.precision == Approx(double(right) / double(made)));
      REQUIRE(point.recall == Approx(double(right) / 300));
      if (point.precision >= 0.7) best = std::max(best, point.recall);
    }
    CHECK(std::ranges::is_sorted(curve, std::less_equal{}, &PrecisionRecall::score));
    CHECK(recallAt(curve, 0.7) == best);
  }
}
