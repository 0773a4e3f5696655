// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/stimulus.hpp"

#include <catch2/catch.hpp>
#include <cstring>

#include "conformance/contract.hpp"
#include "conformance/transcript.hpp"

using namespace tolman;
using namespace tolman::conformance;

namespace {

Stimulus loops() {
  StimulusOptions options;
  options.frames = 150;
  options.turn = 60;
  options.images = false;
  return makeStimulus(options);
}

Stimulus pictures() {
  StimulusOptions options;
  options.frames = 30;
  options.width = 64;
  options.height = 24;
  return makeStimulus(options);
}

std::uint64_t hash(const auto& value) {
  BitHash hash;
  hash.add(value);
  return hash.value();
}

/// What the kit demands of plugins holds for what it shows them.
void demandSound(const Stimulus& stimulus) {
  const Frame* previous = nullptr;
  for (const Moment& moment : stimulus.moments) {
    CHECK(checkMotion(moment.motion, moment.frame, previous).message().empty());
    CHECK(firstInvalidField(moment.motion).empty());
    CHECK(firstInvalidField(moment.place).empty());
    CHECK(firstInvalidField(moment.decision).empty());
    previous = &moment.frame;
  }
}

}  // namespace

TEST_CASE("a drive is sound: ids dense, motions moving, decisions consistent") {
  const Stimulus stimulus = loops();
  demandSound(stimulus);
  std::int64_t templates = 0;
  std::int64_t at = -1;
  std::int64_t version = 0;
  MapGraph graph;
  for (const Moment& moment : stimulus.moments) {
    CHECK(checkPlace(moment.place, templates).message().empty());
    CHECK(checkDecision(moment.decision, at).message().empty());
    at = moment.decision.experience;
    if (moment.graph) graph = *moment.graph;
    CHECK(checkUpdate(moment.map, graph, version).message().empty());
    version = moment.map.version;
  }
  CHECK(templates == 24);
  CHECK(version > 20);  // the second time round, each view closes a loop
}

TEST_CASE("the motions add up to the truth, but for their noise") {
  const Stimulus stimulus = loops();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (const Moment& moment : stimulus.moments) T = T * moment.motion.T_previous_current;
  const Eigen::Isometry3d& truth = stimulus.moments.back().frame.T_world_camera_truth;
  CHECK((T.translation() - truth.translation()).norm() < 1);
  CHECK((T.translation() - truth.translation()).norm() > 0);
}

TEST_CASE("the sensors measure the true motion, and where an earlier round passed") {
  const Stimulus stimulus = loops();
  PlanarPose pose;
  for (const Moment& moment : stimulus.moments) {
    REQUIRE(moment.frame.sensors.size() == 2);
    const std::vector<float>& step = moment.frame.sensors[0].values;
    pose = compose(pose, {step.at(0), step.at(1), step.at(2)});
    const PlanarPose truth = toPlanar(moment.frame.T_world_camera_truth);
    CHECK(pose.x == Approx(truth.x).margin(1e-4));
    CHECK(pose.y == Approx(truth.y).margin(1e-4));
    const std::vector<float>& alike = moment.frame.sensors[1].values;
    if (moment.frame.frame < 60) {
      CHECK(alike.empty());
    } else {
      const auto earlier = static_cast<std::size_t>(alike.at(0));
      CHECK(close(stimulus.moments[earlier].frame.T_world_camera_truth,
                  moment.frame.T_world_camera_truth));
    }
  }
}

TEST_CASE("a seed is a stimulus") {
  StimulusOptions options;
  options.frames = 4;
  const auto left = [&] { return hash(makeStimulus(options).moments[3].frame.left); };
  const auto motion = [&] { return hash(makeStimulus(options).moments[3].motion); };
  const auto first = std::pair(left(), motion());
  CHECK(first == std::pair(left(), motion()));
  options.seed = 2;
  CHECK(first.first != left());
  CHECK(first.second != motion());
}

TEST_CASE("lost images are lost in pairs and say why") {
  Stimulus stimulus = pictures();
  loseImages(stimulus);
  int lost = 0;
  for (const Moment& moment : stimulus.moments) {
    CHECK(moment.frame.left.empty() == moment.frame.right.empty());
    CHECK(moment.frame.left.empty() != moment.frame.defect.empty());
    lost += moment.frame.left.empty() ? 1 : 0;
  }
  CHECK(lost > 5);
  CHECK_FALSE(stimulus.moments.front().frame.left.empty());
  CHECK(stimulus.moments.back().frame.left.empty());
}

TEST_CASE("stand-ins keep the contract: Lost, None, Stay") {
  for (const auto& trouble : {&loseTracking, &startBlind}) {
    Stimulus stimulus = loops();
    trouble(stimulus);
    demandSound(stimulus);
    std::int64_t templates = 0;
    std::int64_t at = -1;
    for (const Moment& moment : stimulus.moments) {
      CHECK(checkPlace(moment.place, templates).message().empty());
      CHECK(checkDecision(moment.decision, at).message().empty());
      at = moment.decision.experience;
    }
    CHECK(templates == 24);
  }
}

TEST_CASE("dropped frames leave gaps; the motion leads over them") {
  const Stimulus whole = loops();
  Stimulus gaps = whole;
  dropFrames(gaps);
  demandSound(gaps);
  CHECK(gaps.moments.size() < whole.moments.size());
  Eigen::Isometry3d T_gaps = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_whole = Eigen::Isometry3d::Identity();
  for (const Moment& moment : gaps.moments) T_gaps = T_gaps * moment.motion.T_previous_current;
  for (const Moment& moment : whole.moments) {
    if (moment.frame.frame > gaps.moments.back().frame.frame) break;
    T_whole = T_whole * moment.motion.T_previous_current;
  }
  CHECK(close(T_gaps, T_whole));
}

TEST_CASE("padding changes the stride and no pixel") {
  const Stimulus plain = pictures();
  Stimulus padded = plain;
  padRows(padded);
  for (std::size_t i = 0; i < plain.moments.size(); ++i) {
    const Image& image = padded.moments[i].frame.right;
    CHECK(image.stride() > image.width());
    CHECK(hash(image) == hash(plain.moments[i].frame.right));
  }
}

TEST_CASE("blind images are of one grey") {
  Stimulus stimulus = pictures();
  blind(stimulus);
  for (const Moment& moment : stimulus.moments) {
    const Image& image = moment.frame.left;
    CHECK(image.width() == stimulus.rig.width);
    CHECK(std::memcmp(image.row(0), image.row(1), static_cast<std::size_t>(image.width())) == 0);
  }
}

TEST_CASE("illegal input is illegal") {
  Stimulus stimulus = pictures();
  turnBackTime(stimulus);
  CHECK(stimulus.moments[2].frame.stamp_ns == stimulus.moments[1].frame.stamp_ns);
  CHECK(stimulus.moments[5].frame.stamp_ns < stimulus.moments[0].frame.stamp_ns);
  stimulus = pictures();
  resizeImages(stimulus);
  CHECK(stimulus.moments[2].frame.left.width() != stimulus.rig.width);
  loseRightImages(stimulus);
  CHECK(stimulus.rig.isStereo());
  CHECK(stimulus.moments[0].frame.right.empty());
}
