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

Motion sound(const Frame& frame) {
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

TEST_CASE("a sound motion passes, each fault is told apart") {
  const Frame before = frameAt(3, 1'000'000'000);
  const Frame now = frameAt(4, 1'500'000'000);
  const auto says = [&](auto&& spoil) {
    Motion motion = sound(now);
    spoil(motion);
    return checkMotion(motion, now, &before).message();
  };
  CHECK(says([](Motion&) {}).empty());
  CHECK(says([](Motion& m) { m.state = TrackingState::Lost; }).empty());
  CHECK(says([](Motion& m) { m.T_previous_current.linear()(0, 0) += 1e-3; }) ==
        "the rotation of 'T_previous_current' is no rotation; use normalised()");
  CHECK(says([](Motion& m) { m.T_previous_current.linear().col(0) *= -1; })  // a mirror
            .starts_with("the rotation"));
  CHECK(says([](Motion& m) { m.covariance(1, 2) = 0.1; }) == "the covariance is not symmetric");
  CHECK(says([](Motion& m) { m.covariance(5, 5) = -1e-9; }) ==
        "the covariance has a negative variance");
  CHECK(says([](Motion& m) { m.dt = 0.4; }).starts_with("dt is 0.400000 s, the stamps say 0.5"));
  CHECK(says([](Motion& m) { m.state = TrackingState::Initialising; }) ==
        "an Initialising motion is the identity");
  CHECK(says([](Motion& m) { m.revisions.resize(1), m.revisions[0].covariance(0, 1) = 3; }) ==
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
  const auto says = [&](Recognition recognition, std::int64_t id) {
    PlaceObservation seen;
    seen.recognition = recognition;
    seen.template_id = id;
    return checkPlace(seen, templates).message();
  };
  CHECK(says(Recognition::None, -1).empty());
  CHECK(says(Recognition::Familiar, 0) == "recognised template 0, which was never made");
  CHECK(says(Recognition::Novel, 0).empty());
  CHECK(says(Recognition::Familiar, 0).empty());
  CHECK(says(Recognition::Novel, 2) == "made template 2; ids are dense, the next one is 1");
  CHECK(says(Recognition::None, 0) == "answered None with template 0; None has template_id -1");
}

TEST_CASE("who stays is where he was") {
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

TEST_CASE("nobody measures without uncertainty") {
  const std::string exact =
      "has_relative_pose with a covariance of zero claims to be exact; say how uncertain the pose "
      "is";
  Decision decision;
  decision.action = Action::CloseLoop;
  decision.has_relative_pose = true;
  CHECK(checkDecision(decision, 0).message() == exact);
  decision.covariance(0, 0) = decision.covariance(2, 2) = 0.01;  // planar: the rest may be nothing
  CHECK(checkDecision(decision, 0).isOk());
  PlaceObservation seen;
  seen.recognition = Recognition::Novel;
  seen.template_id = 0;
  seen.has_relative_pose = true;
  std::int64_t templates = 0;
  CHECK(checkPlace(seen, templates).message() == exact);
}

TEST_CASE("an update counts what the graph has, and its version does not fall") {
  MapGraph graph;
  graph.experiences.resize(2);
  graph.links.resize(1);
  MapUpdate update;
  update.experiences = 2;
  update.links = 1;
  update.version = 3;
  CHECK(checkUpdate(update, graph, 3).isOk());
  CHECK(checkUpdate(update, graph, 4).message() == "the version of the map went down");
  update.experience = 2;
  CHECK(checkUpdate(update, graph, 3).message() ==
        "the frame hangs on experience 2, which does not exist");
  update.experience = 1;
  update.links = 0;
  CHECK_FALSE(checkUpdate(update, graph, 3).isOk());
}

TEST_CASE("poses are close up to rounding") {
  const Eigen::Isometry3d a = fromPlanar({100, 3, 1});
  CHECK(close(a, fromPlanar({100 + 1e-8, 3, 1})));
  CHECK_FALSE(close(a, fromPlanar({100.01, 3, 1})));
}
