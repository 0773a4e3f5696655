// SPDX-License-Identifier: BSD-3-Clause
// The role's contract: decisions, placing of frames, refusals, lost motion, reset.
#include "experience_map.hpp"

#include "map_fixture.hpp"

namespace tolman::experience_map {
namespace {

/// A hilly, winding, rolling step in full 3-D.
Eigen::Isometry3d hillyStep(int k) {
  Vector6d twist;
  twist << 0.02 * std::sin(k), 0.1 * std::sin(0.05 * k), 1.0, 0.01 * std::cos(0.05 * k),
      0.02 * std::sin(0.02 * k), 0.004 * std::cos(0.3 * k);
  return expSe3(twist);
}

Status refuse(Fixture& fixture, const Motion& motion, const Decision& decision) {
  MapUpdate update;
  return fixture.map.update(motion, decision, update);
}

}  // namespace

TEST_CASE("without loops the map is the odometry, in all six dimensions") {
  Fixture fixture;
  std::vector<Eigen::Isometry3d> path = {Eigen::Isometry3d::Identity()};
  fixture.create(path[0]);
  for (int k = 1; k < 500; ++k) {
    path.push_back(path.back() * hillyStep(k));
    const MapUpdate update = k % 7 == 0 ? fixture.create(hillyStep(k)) : fixture.stay(hillyStep(k));
    CHECK(difference(update.T_world_camera, path.back()) < 1e-9);
    const Experience home = fixture.graph().experiences.at(static_cast<std::size_t>(k / 7));
    CHECK(difference(home.T_world_experience * update.T_experience_camera, path.back()) < 1e-9);
  }
  REQUIRE(fixture.map.finish({}).isOk());
  double worst = 0;
  for (std::size_t k = 0; k < path.size(); ++k) {
    worst = std::max(worst, difference(fixture.poseOf(static_cast<std::int64_t>(k)), path[k]));
  }
  CHECK(worst < 1e-9);
  CHECK(fixture.graph().version == 0);
}

TEST_CASE("before the first experience frames hang on the origin") {
  Fixture fixture;
  const MapUpdate first = fixture.stay(Eigen::Isometry3d::Identity());
  CHECK(first.experience == -1);
  const MapUpdate second = fixture.stay(step(1));
  CHECK(second.T_experience_camera.translation().z() == Approx(1));
  const MapUpdate third = fixture.create(step(1));
  CHECK(third.experience == 0);
  CHECK(third.T_world_camera.translation().z() == Approx(2));
  CHECK(difference(third.T_experience_camera, Eigen::Isometry3d::Identity()) < 1e-15);
  CHECK(third.links == 0);
  CHECK(fixture.poseOf(1).translation().z() == Approx(1));
}

TEST_CASE("links carry the accumulated motion, its covariance and its time") {
  Fixture fixture;
  fixture.create(step(0));
  for (int k = 0; k < 4; ++k) fixture.stay(step(1, 0.1));
  const MapUpdate update = fixture.create(step(1, 0.1));
  CHECK(update.links == 1);
  const Link link = fixture.graph().links.at(0);
  Eigen::Isometry3d expected = Eigen::Isometry3d::Identity();
  for (int k = 0; k < 5; ++k) expected = expected * step(1, 0.1);
  CHECK(link.from == 0);
  CHECK(link.to == 1);
  CHECK(link.kind == LinkKind::Odometry);
  CHECK(link.frame == 5);
  CHECK(link.duration == Approx(0.5));  // OpenRatSLAM never restarts this clock
  CHECK(difference(link.T_from_to, expected) < 1e-12);
  CHECK(link.covariance(2, 2) > 5 * 0.01 * 0.01);
}

TEST_CASE("a link over lost motion is weak, and the path goes on") {
  Fixture fixture;
  fixture.create(step(0));
  fixture.create(step(1));
  Motion lost = fixture.motion(step(1));
  lost.state = TrackingState::Lost;
  lost.covariance.setZero();
  const MapUpdate update =
      fixture.feed(lost, fixture.decision(Action::CreateExperience, fixture.created++));
  CHECK(update.T_world_camera.translation().z() == Approx(2));
  const MapGraph graph = fixture.graph();
  CHECK(graph.links[1].covariance(0, 0) > 100 * graph.links[0].covariance(0, 0));
}

TEST_CASE("decisions that make no sense are refused and change nothing") {
  Fixture fixture;
  fixture.create(step(0));
  fixture.create(step(1));
  const Motion motion = fixture.motion(step(1));
  const auto message = [&](Action action, std::int64_t experience) {
    const Status status = refuse(fixture, motion, fixture.decision(action, experience));
    CHECK(status.code() == StatusCode::InvalidInput);
    return status.message();
  };
  CHECK(message(Action::CreateExperience, 5) ==
        "the decision creates experience 5, but the next is 2; ids are 0, 1, 2, ... without gaps");
  CHECK(message(Action::CloseLoop, 2) ==
        "the decision (close_loop) names experience 2, but there are only 2");
  CHECK(message(Action::CloseLoop, -1) ==
        "the decision (close_loop) names experience -1, but there are only 2");
  CHECK(message(Action::Stay, 9) == "the decision (stay) names experience 9, but there are only 2");
  Decision other_frame = fixture.decision(Action::Stay, 1);
  other_frame.frame = 1;
  CHECK(refuse(fixture, motion, other_frame).message() ==
        "the decision is of frame 1, but the motion of frame 2");

  Eigen::Isometry3d T;
  CHECK(fixture.map.poseOf(2, T).message() == "the map has not seen frame 2");
  CHECK(fixture.map.poseOf(2, T).code() == StatusCode::InvalidParameter);
  CHECK(fixture.stay(step(1)).T_world_camera.translation().z() == Approx(2));  // not 3 or 7
}

TEST_CASE("frames that realtime mode left out are unknown, the others are placed") {
  Fixture fixture;
  fixture.create(step(0));
  fixture.frame = 4;
  fixture.stay(step(4));
  Eigen::Isometry3d T;
  CHECK(fixture.map.poseOf(3, T).code() == StatusCode::InvalidParameter);
  CHECK(fixture.poseOf(4).translation().z() == Approx(4));
}

TEST_CASE("after reset the same frames give the same answers bit by bit") {
  Fixture fixture;
  const auto play = [&] {
    fixture.frame = fixture.created = 0;
    fixture.create(hillyStep(0));
    for (int k = 1; k < 120; ++k) {
      if (k % 40 == 0) {
        fixture.close(hillyStep(k), k / 40, 0.05);
      } else if (k % 5 == 0) {
        fixture.create(hillyStep(k));
      } else {
        fixture.stay(hillyStep(k));
      }
    }
    REQUIRE(fixture.map.finish({}).isOk());
    std::vector<Eigen::Isometry3d> path;
    for (int k = 0; k < 120; ++k) path.push_back(fixture.poseOf(k));
    return path;
  };
  const std::vector<Eigen::Isometry3d> first = play();
  CHECK(fixture.graph().version > 0);
  REQUIRE(fixture.map.reset().isOk());
  CHECK(fixture.graph().experiences.empty());
  const std::vector<Eigen::Isometry3d> second = play();
  for (std::size_t k = 0; k < first.size(); ++k) REQUIRE(difference(first[k], second[k]) == 0);
}

TEST_CASE("an empty map can be asked and finished") {
  Fixture fixture;
  CHECK(fixture.graph().experiences.empty());
  CHECK(fixture.map.finish({}).isOk());
}

}  // namespace tolman::experience_map
