// SPDX-License-Identifier: BSD-3-Clause
// The assumed scene of a single camera.
#include <catch2/catch.hpp>

#include "mapper.hpp"
#include "street.hpp"
#include "tracker.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

TEST_CASE("the draft is a street: near below, far ahead, nearer at the sides") {
  Keyframe keyframe;
  const float pixels[4][2] = {{239, 190}, {239, 100}, {470, 100}, {239, 20}};
  for (const auto& pixel : pixels) {
    ImmaturePoint point;
    point.u = pixel[0];
    point.v = pixel[1];
    keyframe.immature.push_back(point);
  }
  draftDepths(test::streetRig(), 1.5, keyframe);
  const auto d = [&](std::size_t i) { return keyframe.immature[i].inverse_depth; };
  CHECK(d(0) == Approx((190 - 99.5) / 300 / 1.5).epsilon(1e-3));  // the ground
  CHECK(d(1) == Approx(1 / 60.0).epsilon(1e-3));
  CHECK(d(2) > d(1));
  CHECK(d(3) == d(1));  // the sky
  for (const ImmaturePoint& point : keyframe.immature) {
    CHECK(point.has_depth);
    CHECK(point.sigma == Approx(0.5F * point.inverse_depth));
  }
}

TEST_CASE("a camera twice as high drafts everything twice as far") {
  Keyframe low;
  low.immature.resize(1);
  low.immature[0].u = 100;
  low.immature[0].v = 150;
  Keyframe high = low;
  draftDepths(test::streetRig(), 1, low);
  draftDepths(test::streetRig(), 2, high);
  CHECK(high.immature[0].inverse_depth == Approx(0.5F * low.immature[0].inverse_depth));
}

TEST_CASE("candidates that failed are no points of the draft") {
  Keyframe keyframe;
  keyframe.immature.resize(5);
  keyframe.immature[2].failures = 3;
  draftPoints(keyframe);
  CHECK(keyframe.points.size() == 4);
}

TEST_CASE("a drafted keyframe is replaced by real depths at the next one") {
  Mapper mapper;
  MapperSettings settings;
  settings.candidates = 600;
  mapper.configure(test::streetRig(), settings);
  ImagePyramid first = test::streetPyramid(test::streetPose(0));
  mapper.draftKeyframe(0, Eigen::Isometry3d::Identity(), 1.5, first);
  CHECK(mapper.isDraft());
  CHECK(mapper.window().pointCount() > 200);
  for (int k = 1; k < 6; ++k) {
    const Eigen::Isometry3d pose = test::streetPose(0.2 * k);
    mapper.observe(pose, Affine(), test::streetPyramid(pose));
  }
  ImagePyramid second = test::streetPyramid(test::streetPose(1.2));
  ImagePyramid none;
  mapper.addKeyframe(6, test::streetPose(1.2), Affine(), second, none);
  CHECK_FALSE(mapper.isDraft());
  CHECK(mapper.window().size() == 2);
  const Keyframe& keyframe = mapper.window().keyframe(0);
  REQUIRE(keyframe.points.size() > 60);
  int right = 0;
  for (const Point& p : keyframe.points) {
    const double truth = test::streetInverseDepth(test::streetPose(0), p.u, p.v);
    right += std::abs(p.inverse_depth - truth) < 0.1 * truth ? 1 : 0;
  }
  CHECK(10 * right > 8 * static_cast<int>(keyframe.points.size()));
}
