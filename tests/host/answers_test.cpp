// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "host/values.hpp"

using namespace tolman;
using namespace tolman::host;

namespace {

Motion validMotion() {
  Motion motion;
  motion.frame = 4;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current = fromPlanar({1, 0.2, 0.3});
  motion.covariance.setIdentity();
  return motion;
}

std::string covarianceMessage(const Matrix6d& covariance) {
  return checkCovariance(covariance, "c").message();
}

/// With element (row, column) and its mirror set.
Matrix6d identityWith(int row, int column, double value) {
  Matrix6d covariance = Matrix6d::Identity();
  covariance(row, column) = covariance(column, row) = value;
  return covariance;
}

const std::string kExact = "'covariance' is zero, which claims an exact pose; set it";

}  // namespace

TEST_CASE("covariances are symmetric and positive semidefinite") {
  CHECK(covarianceMessage(Matrix6d::Zero()).empty());
  CHECK(covarianceMessage(1e-30 * Matrix6d::Identity()).empty());
  CHECK(covarianceMessage(1e30 * Matrix6d::Identity()).empty());
  Matrix6d skew = Matrix6d::Identity();
  skew(1, 2) = 0.1;
  CHECK(covarianceMessage(skew) == "'c' is not symmetric");
  CHECK(covarianceMessage(identityWith(5, 5, -1e-9)) == "'c' has a negative variance");
  CHECK(covarianceMessage(-Matrix6d::Identity()) == "'c' has a negative variance");
  CHECK(covarianceMessage(identityWith(0, 5, 1.01)) == "'c' is not positive semidefinite");
  CHECK(covarianceMessage(identityWith(0, 5, 1)).empty());  // singular
}

TEST_CASE("a covariance of one direction and the inverse of a bad information matrix pass") {
  Vector6d direction;
  direction << 3, -1e-3, 2e3, 1e-5, 0, 7;
  CHECK(covarianceMessage(direction * direction.transpose()).empty());
  Matrix6d information = direction * direction.transpose();
  information.diagonal() += Vector6d::Constant(1e-3);
  CHECK(covarianceMessage(information.inverse()).empty());
}

TEST_CASE("a valid motion passes, each fault has its message") {
  const auto message = [](auto&& change) {
    Motion motion = validMotion();
    change(motion);
    return checkMotion(motion, false).message();
  };
  CHECK(message([](Motion&) {}).empty());
  CHECK(message([](Motion& m) { m.state = TrackingState::Lost; }).empty());
  CHECK(message([](Motion& m) { m.covariance.setZero(); }).empty());
  CHECK(message([](Motion& m) { m.covariance(1, 2) = 0.1; }) == "'covariance' is not symmetric");
  CHECK(message([](Motion& m) { m.state = TrackingState::Initialising; }) ==
        "an Initialising motion is the identity");
  CHECK(message([](Motion& m) { m.tracked = -9; }) == "'tracked' is -9, a number of measurements");
  const auto points_of = [&](std::int64_t frame) {
    return message([&](Motion& m) { m.points_frame = frame, m.points.setOnes(4, 1); });
  };
  CHECK(points_of(4).empty());
  CHECK(points_of(5) == "points of frame 5, which is not a past frame");
  CHECK(points_of(-1) == "points of frame -1, which is not a past frame");
}

TEST_CASE("at frame 0 there is no motion") {
  CHECK(checkMotion(Motion(), true).isOk());
  CHECK(checkMotion(validMotion(), true).message() ==
        "frame 0 has no motion: answer Initialising and the identity");
}

TEST_CASE("revisions are of past frames") {
  std::vector<MotionRevision> revisions(1);
  revisions[0].frame = 5;
  CHECK(checkRevisions(revisions, 5, 5).isOk());
  CHECK(checkRevisions(revisions, 6, 9).message() == "revised frame 5, which is not a past frame");
  CHECK_FALSE(checkRevisions(revisions, 0, 4).isOk());
  revisions[0].covariance(0, 1) = 3;
  CHECK(checkRevisions(revisions, 0, 9).message() == "'revisions.covariance' is not symmetric");
}

TEST_CASE("template ids are 0, 1, 2, ... without gaps") {
  const auto message = [&](Recognition recognition, std::int64_t id, std::int64_t templates) {
    PlaceObservation seen;
    seen.recognition = recognition;
    seen.template_id = id;
    return checkTemplateId(seen, templates).message();
  };
  CHECK(message(Recognition::None, -1, 0).empty());
  CHECK(message(Recognition::Familiar, 0, 0) == "recognised template 0, which was never made");
  CHECK(message(Recognition::Novel, 0, 0).empty());
  CHECK(message(Recognition::Familiar, 0, 1).empty());
  CHECK(message(Recognition::Novel, 2, 1) ==
        "made template 2; ids are 0, 1, 2, ... without gaps, the next one is 1");
  CHECK(message(Recognition::None, 0, 1) ==
        "answered None with template 0; None has template_id -1");
  CHECK(message(Recognition::Novel, 7, -1).empty());
  CHECK_FALSE(message(Recognition::Novel, -2, -1).empty());
}

TEST_CASE("a decision names a template that place recognition gave") {
  Decision decision;
  decision.experience = 4;
  decision.template_id = 8;
  CHECK(checkDecision(decision, 5, 4, 9).isOk());
  CHECK(checkDecision(decision, 5, 4, 8).message() ==
        "decided by template 8, which place recognition never gave");
}

TEST_CASE("Stay keeps the experience of the last decision") {
  Decision decision;
  decision.experience = 4;
  CHECK(checkDecision(decision, 5, 4).isOk());
  CHECK(checkDecision(decision, 5, -2).isOk());  // not known
  CHECK(checkDecision(decision, 5, 3).message() == "stays at experience 4, but was at 3");
  decision.action = Action::CloseLoop;
  CHECK(checkDecision(decision, 5, 3).isOk());
}

TEST_CASE("a relative pose needs a covariance") {
  Decision decision;
  decision.action = Action::CloseLoop;
  decision.experience = 0;
  CHECK(checkDecision(decision, 1, 0).isOk());
  decision.has_relative_pose = true;
  CHECK(checkDecision(decision, 1, 0).message() == kExact);
  decision.covariance(0, 0) = decision.covariance(2, 2) = 0.01;  // planar: the rest may be zero
  CHECK(checkDecision(decision, 1, 0).isOk());
  decision.covariance = -Matrix6d::Identity();
  CHECK(checkDecision(decision, 1, 0).message() == "'covariance' has a negative variance");
  PlaceObservation seen;
  CHECK(checkPlace(seen).isOk());
  seen.has_relative_pose = true;
  CHECK(checkPlace(seen).message() == kExact);
}

TEST_CASE("loops of earlier frames have a covariance") {
  Decision decision;
  decision.frame = 9;
  decision.experience = 4;
  EarlierLoop& loop = decision.earlier.emplace_back();
  loop.frame = loop.experience = 3;
  CHECK(checkDecision(decision, 5, 4).message() ==
        "'earlier.covariance' is zero, which claims an exact pose; set it");
  loop.covariance.setIdentity();
  CHECK(checkDecision(decision, 5, 4).isOk());
}

TEST_CASE("an update is attached to a known experience, its version does not decrease") {
  MapUpdate update;
  update.experiences = 2;
  update.version = 3;
  CHECK(checkUpdate(update, 3).isOk());  // a session that has not yet joined an earlier one
  CHECK(checkUpdate(update, 4).message() == "the version of the map decreased");
  update.experience = 2;
  CHECK(checkUpdate(update, 3).message() ==
        "the frame is attached to experience 2, which does not exist");
  update.experience = 1;
  update.links = -1;
  CHECK(checkUpdate(update, 3).message() == "a number of links is negative");
  update.links = 1;
  update.loops = 2;
  CHECK(checkUpdate(update, 3).message() == "2 loops of 1 links");
}

TEST_CASE("the ids of a graph have no gaps, and its frames are past") {
  MapGraph graph;
  graph.experiences.resize(2);
  graph.links.resize(1);
  const auto message = [&] { return checkGraph(graph, {.newest_frame = 7}).message(); };
  CHECK(
      message() ==
      "experience 0 of the graph has the id -1; ids are 0, 1, 2, ... without gaps, in this order");
  for (std::int64_t i : {0, 1}) {
    auto& experience = graph.experiences[static_cast<std::size_t>(i)];
    experience.id = i;
    experience.frame = 7 + i;
  }
  CHECK(message() == "experience 1 was made at frame 8, which is not a past frame");
  graph.experiences[1].frame = 7;
  CHECK(message() ==
        "link 0 of the graph has the id -1; ids are 0, 1, 2, ... without gaps, in this order");
  Link& link = graph.links[0];
  link.id = link.from = 0;
  link.to = 2;
  CHECK(message() == "link 0 has an unknown experience");
  link.to = 1;
  CHECK(message() == "link 0 was made at frame -1, which is not a past frame");
  link.frame = 7;
  CHECK(message().empty());
  link.T_from_to.linear().setZero();
  CHECK(message() == "the rotation of 'T_from_to' is not orthonormal; use normalised()");
}

TEST_CASE("links have a duration, a weight and a covariance, rejected ones are loops") {
  MapGraph graph;
  graph.experiences.resize(2);
  for (std::int64_t i : {0, 1}) {
    graph.experiences[static_cast<std::size_t>(i)].id = i;
    graph.experiences[static_cast<std::size_t>(i)].frame = i;
  }
  Link& link = graph.links.emplace_back();
  link.id = link.from = 0;
  link.to = link.frame = 1;
  const auto message = [&] { return checkGraph(graph, {.newest_frame = 1}).message(); };
  CHECK(message().empty());
  link.duration = -2;
  CHECK(message() == "link 0 has a duration of -2 s");
  link.duration = 1e50;
  CHECK(message() == "link 0 has a duration of 1e+50 s");
  link.duration = 0;
  link.weight = 1.5;
  CHECK(message() == "link 0 has a weight of 1.5, which is not in [0, 1]");
  link.weight = 1;
  link.covariance = -Matrix6d::Identity();
  CHECK(message() == "'covariance' has a negative variance");
  link.covariance.setIdentity();
  graph.rejected = {0};
  CHECK(message() == "rejected link 0 is no loop link of the graph");
  link.kind = LinkKind::Loop;
  CHECK(message().empty());
  graph.rejected = {0, 0};
  CHECK(message() == "the ids of rejected links are not ascending from 0");
  graph.rejected.clear();
  graph.experiences[1].template_id = -50;
  CHECK(message() == "experience 1 has template -50; -1 for none");
  graph.experiences[1].template_id = 3;
  CHECK(message().empty());  // of an earlier session, perhaps
  CHECK(checkGraph(graph, {.newest_frame = 1, .templates = 4}).isOk());
  CHECK(checkGraph(graph, {.newest_frame = 1, .templates = 3}).message() ==
        "experience 1 has template 3, which no decision named");
}

TEST_CASE("a graph is that of the last update") {
  MapGraph graph;
  graph.version = 3;
  CHECK(checkGraph(graph, {.version = 3, .experiences = 0}).isOk());
  CHECK(checkGraph(graph, {.version = 4, .experiences = 0}).message() ==
        "the version of the map decreased");
  CHECK(checkGraph(graph, {.version = 3, .experiences = 2}).message() ==
        "the graph has 0 experiences, the last update 2");
  CHECK(checkGraph(graph, {.links = 0, .loops = 0}).isOk());
  CHECK(checkGraph(graph, {.links = 5}).message() == "the graph has 0 links, the last update 5");
  graph.experiences.resize(1);
  graph.experiences[0].id = graph.experiences[0].frame = 0;
  Link& link = graph.links.emplace_back();
  link.id = link.from = link.to = link.frame = 0;
  CHECK(checkGraph(graph, {.links = 1, .loops = 0}).isOk());
  CHECK(checkGraph(graph, {.links = 1, .loops = 1}).message() ==
        "the graph has 0 loop links, the last update 1");
  link.kind = LinkKind::Loop;
  graph.rejected = {0};
  CHECK(checkGraph(graph, {.links = 1, .loops = 1}).isOk());  // rejected ones count
}

TEST_CASE("an update has the frame where the graph puts it") {
  MapGraph graph;
  graph.experiences.resize(2);
  graph.experiences[1].T_world_experience = fromPlanar({3, 4, 1});
  MapUpdate update;
  update.experience = 1;
  update.T_experience_camera = fromPlanar({1, 0, 0.5});
  update.T_world_camera = graph.experiences[1].T_world_experience * update.T_experience_camera;
  CHECK(checkPlaced(update, graph).isOk());
  update.T_world_camera.translation().y() += 0.5;
  CHECK(checkPlaced(update, graph).message() ==
        "is 0.5 m and 0 rad from the pose by experience 1 of graph() and T_experience_camera of "
        "the update");
  update.experience = -1;  // of no experience yet
  CHECK(checkPlaced(update, graph).isOk());
}

TEST_CASE("poses that are kept in single precision are the same, others are not") {
  const Eigen::Isometry3d far = fromPlanar({12345.678, -9876.543, 2.345});
  const Eigen::Isometry3d rounded(far.cast<float>().cast<double>());
  CHECK(checkSamePose(far, rounded, "it").isOk());
  Eigen::Isometry3d moved = far;
  moved.translation().x() += 1;
  CHECK(checkSamePose(far, moved, "it").message() == "is 1 m and 0 rad from the pose by it");
  const Eigen::Isometry3d here = fromPlanar({1, 2, 0});
  CHECK(checkSamePose(here, fromPlanar({1, 2.0009, 0}), "it").isOk());
  CHECK_FALSE(checkSamePose(here, fromPlanar({1, 2.0011, 0}), "it").isOk());
  CHECK(checkSamePose(here, fromPlanar({1, 2, 0.25}), "it").message() ==
        "is 0 m and 0.25 rad from the pose by it");
}
