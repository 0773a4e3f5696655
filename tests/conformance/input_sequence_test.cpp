// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "conformance/hash_of.hpp"
#include "conformance/test_instance.hpp"
#include "host/values.hpp"

using namespace tolman;
using namespace tolman::conformance;

namespace {

InputSequence withLoops(bool stops = false) {
  SequenceOptions options;
  options.frames = 150;
  options.turn = 60;
  options.images = false;
  options.stops = stops;
  return makeSequence(options);
}

InputSequence withImages() {
  SequenceOptions options;
  options.frames = 30;
  options.width = 64;
  options.height = 24;
  return makeSequence(options);
}

bool close(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).norm() < 1e-6 * (1 + a.translation().norm());
}

/// The generated records satisfy the contract of host and kit. Returns the number of templates.
/// `is_whole`: no frame is missing.
std::int64_t checkContract(const InputSequence& sequence, bool is_whole = true) {
  const Frame* previous = nullptr;
  std::int64_t templates = 0;
  std::int64_t experiences = 0;
  std::int64_t at = -1;
  for (const auto& [frame, motion, place, decision, map, cells, graph] : sequence.inputs) {
    CHECK(host::checkMotion(motion, previous == nullptr && frame.frame == 0).message().empty());
    const std::int64_t passed_ns = previous ? frame.stamp_ns - previous->stamp_ns : 0;
    CHECK(motion.dt == Approx(1e-9 * static_cast<double>(passed_ns)).margin(1e-6));
    CHECK(host::checkRevisions(motion.revisions, 0, frame.frame).message().empty());
    CHECK(host::checkTemplateId(place, templates).message().empty());
    CHECK(host::checkPlace(place).message().empty());
    const bool creates = decision.action == Action::CreateExperience;
    // Those of skipped and dropped frames are there, too.
    experiences = std::max(experiences, decision.experience + (creates ? 0 : 1));
    CHECK(host::checkDecision(decision, experiences, is_whole ? at : -2).message().empty());
    CHECK(host::checkValues(motion).message().empty());
    CHECK(host::checkValues(place).message().empty());
    CHECK(host::checkValues(decision).message().empty());
    if (place.recognition == Recognition::Novel) ++templates;
    at = decision.experience;
    previous = &frame;
  }
  return templates;
}

}  // namespace

TEST_CASE("a sequence keeps the contract: dense ids, non-zero motions, consistent decisions") {
  const InputSequence sequence = withLoops(GENERATE(false, true));
  CHECK(checkContract(sequence) == 24);
  std::int64_t version = 0;
  MapGraph graph;
  for (const FrameInput& input : sequence.inputs) {
    if (input.graph) graph = *input.graph;
    CHECK(host::checkUpdate(input.map, version).message().empty());
    const host::KnownMap known = {
        .experiences = input.map.experiences, .links = input.map.links, .loops = input.map.loops};
    CHECK(host::checkGraph(graph, known).message().empty());
    CHECK(host::checkPlaced(input.map, graph).message().empty());
    version = input.map.version;
  }
  CHECK(version > 20);  // the second time round, each view closes a loop
}

TEST_CASE("the motions add up to the ground truth within their noise") {
  const InputSequence sequence = withLoops();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (const FrameInput& input : sequence.inputs) T = T * input.motion.T_previous_current;
  const Eigen::Isometry3d& truth = sequence.inputs.back().frame.T_world_camera_truth;
  CHECK((T.translation() - truth.translation()).norm() < 1);
  CHECK((T.translation() - truth.translation()).norm() > 0);
}

TEST_CASE("the sensor arrays hold the true motion and the frame of the previous circle") {
  const InputSequence sequence = withLoops(GENERATE(false, true));
  PlanarPose pose;
  for (const FrameInput& input : sequence.inputs) {
    REQUIRE(input.frame.sensors.size() == 2);
    const std::vector<float>& step = input.frame.sensors[0].values;
    pose = compose(pose, {step.at(0), step.at(1), step.at(2)});
    const PlanarPose truth = toPlanar(input.frame.T_world_camera_truth);
    CHECK(pose.x == Approx(truth.x).margin(1e-4));
    CHECK(pose.y == Approx(truth.y).margin(1e-4));
    const std::vector<float>& candidate = input.frame.sensors[1].values;
    if (input.frame.frame < 60) {
      CHECK(candidate.empty());
    } else {
      const auto earlier = static_cast<std::size_t>(candidate.at(0));
      CHECK(close(sequence.inputs[earlier].frame.T_world_camera_truth,
                  input.frame.T_world_camera_truth));
    }
  }
}

TEST_CASE("in the second circle a drive with stops stands, goes on, reverses, and goes on") {
  const InputSequence sequence = withLoops(true);
  const auto speed = [&](std::size_t k) { return sequence.inputs.at(k).motion.v; };
  CHECK(speed(70) > 2);
  CHECK(std::abs(speed(86)) < 0.2);
  CHECK(speed(95) > 2);
  CHECK(speed(104) < -2);
  CHECK(speed(115) > 2);
  const auto& last = sequence.inputs.back();
  CHECK(last.place.recognition == Recognition::Familiar);
}

TEST_CASE("a seed determines the sequence") {
  SequenceOptions options;
  options.frames = 4;
  const auto left = [&] { return test::hashOf(makeSequence(options).inputs[3].frame.left); };
  const auto motion = [&] { return test::hashOf(makeSequence(options).inputs[3].motion); };
  const auto first = std::pair(left(), motion());
  CHECK(first == std::pair(left(), motion()));
  options.seed = 2;
  CHECK(first.first != left());
  CHECK(first.second != motion());
}

TEST_CASE("images are removed in pairs, with a defect") {
  InputSequence sequence = withImages();
  removeImages(sequence);
  int lost = 0;
  for (const FrameInput& input : sequence.inputs) {
    CHECK(input.frame.left.empty() == input.frame.right.empty());
    CHECK(input.frame.left.empty() != input.frame.defect.empty());
    lost += input.frame.left.empty() ? 1 : 0;
  }
  CHECK(lost > 5);
  CHECK_FALSE(sequence.inputs.front().frame.left.empty());
  CHECK(sequence.inputs.back().frame.left.empty());
}

TEST_CASE("records of skipped stages keep the contract: Lost, None, Stay") {
  InputSequence sequence = withLoops();
  loseTracking(sequence);
  CHECK(checkContract(sequence) == 24);
}

TEST_CASE("the motion after dropped frames spans the gap") {
  const InputSequence whole = withLoops();
  InputSequence gaps = whole;
  dropFrames(gaps);
  checkContract(gaps, false);
  CHECK(gaps.inputs.size() < whole.inputs.size());
  Eigen::Isometry3d T_gaps = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_whole = Eigen::Isometry3d::Identity();
  for (const FrameInput& input : gaps.inputs) T_gaps = T_gaps * input.motion.T_previous_current;
  for (const FrameInput& input : whole.inputs) {
    if (input.frame.frame > gaps.inputs.back().frame.frame) break;
    T_whole = T_whole * input.motion.T_previous_current;
  }
  CHECK(close(T_gaps, T_whole));
}

TEST_CASE("padding changes the stride and no pixel") {
  const InputSequence plain = withImages();
  InputSequence padded = plain;
  padRows(padded);
  for (std::size_t i = 0; i < plain.inputs.size(); ++i) {
    const Image& image = padded.inputs[i].frame.right;
    CHECK(image.stride() > image.width());
    CHECK(test::hashOf(image) == test::hashOf(plain.inputs[i].frame.right));
  }
}

TEST_CASE("textureless images have one grey level") {
  InputSequence sequence = withImages();
  makeTextureless(sequence);
  for (const FrameInput& input : sequence.inputs) {
    const Image& image = input.frame.left;
    CHECK(image.width() == sequence.rig.width);
    CHECK(std::memcmp(image.row(0), image.row(1), static_cast<std::size_t>(image.width())) == 0);
  }
}

TEST_CASE("depth images agree with the depths of the points, and are given on demand") {
  SequenceOptions options;
  options.frames = 3;
  options.width = 64;
  options.height = 24;
  const auto depthOf = [](const Frame& frame) {
    return std::ranges::find(frame.sensors, "depth.left", &NamedArray::name);
  };
  const InputSequence plain = makeSequence(options);
  CHECK(depthOf(plain.inputs[1].frame) == plain.inputs[1].frame.sensors.end());
  options.depth = true;
  const InputSequence sequence = makeSequence(options);
  for (std::size_t k = 1; k < 3; ++k) {
    const auto& [frame, motion, place, decision, map, cells, graph] = sequence.inputs[k];
    const auto depth = depthOf(frame);
    REQUIRE(depth != frame.sensors.end());
    CHECK(depth->shape == std::vector<int>{24, 64});
    REQUIRE(motion.points.cols() > 0);
    for (Eigen::Index i = 0; i < motion.points.cols(); ++i) {
      // The points lie between pixels, so four pixels have a depth on both sides, but at edges.
      const auto at = static_cast<std::size_t>(motion.points(1, i)) * 64 +
                      static_cast<std::size_t>(motion.points(0, i));
      const auto [nearest, farthest] =
          std::minmax({depth->values[at], depth->values[at + 1], depth->values[at + 64],
                       depth->values[at + 65]});
      if (farthest > 1.1F * nearest) continue;
      const float of_point = 1 / motion.points(2, i);
      CHECK(of_point >= 0.999F * nearest);
      CHECK(of_point <= 1.001F * farthest);
    }
  }
}
