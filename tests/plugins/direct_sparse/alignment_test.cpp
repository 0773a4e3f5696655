// SPDX-License-Identifier: BSD-3-Clause
// Direct alignment on the rendered street: convergence, brightness, derivatives, flow.
#include "alignment.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "harness.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

struct Case {
  CameraRig rig = test::streetRig();
  std::unique_ptr<Window> window = test::streetWindow({test::streetPose(0)});
  AlignmentReference reference;
  Aligner aligner;

  Case() {
    test::addTruePoints(*window, 600);
    reference.build(rig, *window);
  }
  AlignmentResult align(const ImagePyramid& image, const AlignmentState& guess = {}) {
    return aligner.align(rig, reference, image, guess, reference.levels() - 1, 0);
  }
};

double metresOff(const AlignmentResult& result, const Eigen::Isometry3d& truth) {
  return (result.state.T_current_reference * truth).translation().norm();
}

}  // namespace

TEST_CASE("a frame's pose is found to millimetres from standstill") {
  Case c;
  for (const auto& pose : {test::streetPose(0.3, 0.01), test::streetPose(-0.3, -0.01)}) {
    const AlignmentResult result = c.align(test::streetPyramid(pose));
    CHECK(metresOff(result, pose) < 0.004);
    const Eigen::Matrix3d error = result.state.T_current_reference.linear() * pose.linear();
    CHECK(logSo3(error).norm() < 2e-4);
    CHECK(result.inlier_fraction > 0.9);
    CHECK(result.rms < 6);
    CHECK(result.samples > 500);
  }
}

TEST_CASE("brightness changes are found along with the pose") {
  Case c;
  const Eigen::Isometry3d pose = test::streetPose(0.2, 0.005);
  const Frame frame = test::streetFrame(0, pose);
  ImagePyramid darker;
  darker.build(test::changed(frame.left, 0.7, 8));
  const AlignmentResult result = c.align(darker);
  // Errors of the reference's values make the gain look smaller, so compare where the values are.
  for (const double level : {90.0, 125.0, 160.0}) {
    const double seen = std::exp(result.state.brightness.a) * level + result.state.brightness.b;
    CHECK(seen == Approx(0.7 * level + 8).margin(4));
  }
  CHECK(metresOff(result, pose) < 0.006);
}

TEST_CASE("derivatives of the reference are those of its image when the scene moves") {
  Case c;
  const ReferenceLevel& level = c.reference.level(1);
  const GrayLevel& image = c.window->newest().left.level(1);
  const float f = 150;
  const float cx = toLevel(239.5F, 1);
  const float cy = toLevel(99.5F, 1);
  constexpr double h = 1e-3;
  int checked = 0;
  for (std::size_t i = 0; i < level.count; i += 29) {
    const Eigen::Vector3d p = Eigen::Vector3d(level.x[i], level.y[i], 1) / level.d[i];
    for (int k = 0; k < 6; ++k) {
      // Half a pixel each way, as the differences behind the gradient are.
      const auto value = [&](double step) {
        const Vector6d twist = step * Vector6d::Unit(k);
        const Eigen::Vector3d q = expSe3(twist) * p;
        return Eigen::Vector2f(static_cast<float>(f * q.x() / q.z()) + cx,
                               static_cast<float>(f * q.y() / q.z()) + cy);
      };
      const Eigen::Vector2f slope = (value(h) - value(-h)) / static_cast<float>(2 * h);
      const Eigen::Vector2f at = value(0);
      const float gx = 0.5F * (image.at(at.x() + 1, at.y()) - image.at(at.x() - 1, at.y()));
      const float gy = 0.5F * (image.at(at.x(), at.y() + 1) - image.at(at.x(), at.y() - 1));
      const float expected = gx * slope.x() + gy * slope.y();
      CHECK(level.by_twist[static_cast<std::size_t>(k)][i] ==
            Approx(expected).epsilon(0.01).margin(0.5));
      ++checked;
    }
  }
  CHECK(checked > 100);
}

TEST_CASE("levels are padded with samples of no weight, and have one sample a pixel") {
  Case c;
  for (int l = 0; l < c.reference.levels(); ++l) {
    const ReferenceLevel& level = c.reference.level(l);
    const std::size_t padded = level.groups() * ReferenceLevel::kGroup;
    CHECK(padded >= level.count);
    CHECK(padded - level.count < ReferenceLevel::kGroup);
    REQUIRE(padded <= level.x.size());
    for (std::size_t i = level.count; i < padded; ++i) CHECK(level.weight[i] == 0);
    const GrayLevel& image = c.window->newest().left.level(l);
    CHECK(level.count <= static_cast<std::size_t>(image.width * image.height));
  }
  CHECK(c.reference.level(0).count > c.reference.level(3).count);
}

TEST_CASE("flow tells turning from driving, and coverage what is left of the view") {
  Case c;
  AlignmentResult result;
  measureFlow(c.rig, c.reference, result);
  CHECK(result.flow == 0);
  CHECK(result.coverage == Approx(1));
  result.state.T_current_reference = test::streetPose(0, 0.05).inverse();
  measureFlow(c.rig, c.reference, result);
  CHECK(result.flow == Approx(15).epsilon(0.2));  // 300 px * 0.05
  CHECK(result.translation_flow < 1e-3);
  result.state.T_current_reference = test::streetPose(0.5).inverse();
  measureFlow(c.rig, c.reference, result);
  CHECK(result.translation_flow == Approx(result.flow));
  CHECK(result.flow > 1);
  result.state.T_current_reference = test::streetPose(-8).inverse();
  measureFlow(c.rig, c.reference, result);
  CHECK(result.coverage < 0.7);  // driving back, all that is seen moves together
}

TEST_CASE("alignment has the same bits for one, two and four threads") {
  const ImagePyramid image = test::streetPyramid(test::streetPose(0.25, 0.01));
  std::vector<Eigen::Matrix4d> found;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Case c;
    found.push_back(c.align(image).state.T_current_reference.matrix());
  }
  CHECK(found[1] == found[0]);
  CHECK(found[2] == found[0]);
}
