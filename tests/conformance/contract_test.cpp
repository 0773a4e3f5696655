// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/contract.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::conformance;

namespace {

Frame frameAt(std::int64_t frame, std::int64_t stamp_ns) {
  Frame made;
  made.frame = frame;
  made.stamp_ns = stamp_ns;
  return made;
}

Motion validMotion(const Frame& frame) {
  Motion motion;
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current = fromPlanar({1, 0.2, 0.3});
  motion.covariance.setIdentity();
  motion.dt = 0.5;
  return motion;
}

}  // namespace

TEST_CASE("a valid motion passes, each fault has its message") {
  const Frame before = frameAt(3, 1'000'000'000);
  const Frame now = frameAt(4, 1'500'000'000);
  const auto message = [&](auto&& change) {
    Motion motion = validMotion(now);
    change(motion);
    return checkMotion(motion, now, &before).message();
  };
  CHECK(message([](Motion&) {}).empty());
  CHECK(message([](Motion& m) { m.state = TrackingState::Lost; }).empty());
  CHECK(message([](Motion& m) { m.T_previous_current.linear()(0, 0) += 1e-3; }) ==
        "the rotation of 'T_previous_current' is not orthonormal; use normalised()");
  CHECK(message([](Motion& m) { m.T_previous_current.linear().col(0) *= -1; })  // a mirror
            .starts_with("the rotation"));
  CHECK(message([](Motion& m) { m.covariance(1, 2) = 0.1; }) == "the covariance is not symmetric");
  CHECK(message([](Motion& m) { m.covariance(5, 5) = -1e-9; }) ==
        "the covariance has a negative variance");
  CHECK(message([](Motion& m) { m.dt = 0.4; }).starts_with("dt is 0.400000 s, the stamps say 0.5"));
  CHECK(message([](Motion& m) { m.state = TrackingState::Initialising; }) ==
        "an Initialising motion is the identity");
  CHECK(message([](Motion& m) { m.revisions.resize(1), m.revisions[0].covariance(0, 1) = 3; }) ==
        "the covariance is not symmetric");
}

TEST_CASE("at frame 0 there is no motion") {
  const Frame first = frameAt(0, 77);
  Motion motion;
  motion.frame = 0;
  CHECK(checkMotion(motion, first, nullptr).isOk());
  motion.state = TrackingState::Tracking;
  CHECK_FALSE(checkMotion(motion, first, nullptr).isOk());
}

TEST_CASE("template ids are dense from 0") {
  std::int64_t templates = 0;
  const auto message = [&](Recognition recognition, std::int64_t id) {
    PlaceObservation seen;
    seen.recognition = recognition;
    seen.template_id = id;
    return checkPlace(seen, templates).message();
  };
  CHECK(message(Recognition::None, -1).empty());
  CHECK(message(Recognition::Familiar, 0) == "recognised template 0, which was never made");
  CHECK(message(Recognition::Novel, 0).empty());
  CHECK(message(Recognition::Familiar, 0).empty());
  CHECK(message(Recognition::Novel, 2) == "made template 2; ids are dense, the next one is 1");
  CHECK(message(Recognition::None, 0) == "answered None with template 0; None has template_id -1");
}

TEST_CASE("Stay keeps the experience of the last decision") {
  Decision decision;
  decision.experience = 4;
  CHECK(checkDecision(decision, 4).isOk());
  CHECK(checkDecision(decision, 3).message() == "stays at experience 4, but was at 3");
  decision.action = Action::CloseLoop;
  CHECK(checkDecision(decision, 3).isOk());
  decision.has_relative_pose = true;
  decision.T_experience_current.linear().setZero();
  CHECK_FALSE(checkDecision(decision, 3).isOk());
}

TEST_CASE("loops of earlier frames have a pose and a covariance") {
  Decision decision;
  decision.experience = 4;
  EarlierLoop& loop = decision.earlier.emplace_back();
  CHECK(checkDecision(decision, 4).message() ==
        "has_relative_pose with zero covariance claims an exact pose; set its covariance");
  loop.covariance.setIdentity();
  CHECK(checkDecision(decision, 4).isOk());
  loop.T_experience_camera.linear().setZero();
  CHECK(checkDecision(decision, 4).message() ==
        "the rotation of 'earlier.T_experience_camera' is not orthonormal; use normalised()");
}

TEST_CASE("a relative pose needs a covariance") {
  const std::string exact =
      "has_relative_pose with zero covariance claims an exact pose; set its covariance";
  Decision decision;
  decision.action = Action::CloseLoop;
  decision.has_relative_pose = true;
  CHECK(checkDecision(decision, 0).message() == exact);
  decision.covariance(0, 0) = decision.covariance(2, 2) = 0.01;  // planar: the rest may be zero
  CHECK(checkDecision(decision, 0).isOk());
  PlaceObservation seen;
  seen.recognition = Recognition::Novel;
  seen.template_id = 0;
  seen.has_relative_pose = true;
  std::int64_t templates = 0;
  CHECK(checkPlace(seen, templates).message() == exact);
}

TEST_CASE("the counts of an update agree with the graph, its version does not decrease") {
  MapGraph graph;
  graph.experiences.resize(2);
  graph.links.resize(1);
  MapUpdate update;
  update.experiences = 2;
  update.links = 1;
  update.version = 3;
  CHECK(checkUpdate(update, graph, 3).isOk());
  CHECK(checkUpdate(update, graph, 4).message() == "the version of the map decreased");
  update.experience = 2;
  CHECK(checkUpdate(update, graph, 3).message() ==
        "the frame is attached to experience 2, which does not exist");
  update.experience = 1;
  update.links = 0;
  CHECK_FALSE(checkUpdate(update, graph, 3).isOk());
}

TEST_CASE("poses are close up to rounding") {
  const Eigen::Isometry3d a = fromPlanar({100, 3, 1});
  CHECK(close(a, fromPlanar({100 + 1e-8, 3, 1})));
  CHECK_FALSE(close(a, fromPlanar({100.01, 3, 1})));
}
