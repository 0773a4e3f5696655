// SPDX-License-Identifier: BSD-3-Clause
// Spacing of points, and depths on which the keyframes agree.
#include "activation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "point_selection.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

/// Three keyframes; the middle one has candidates with depths that are off by `factor`.
std::unique_ptr<Window> withCandidates(float factor, int wanted = 300) {
  auto window =
      test::streetWindow({test::streetPose(0), test::streetPose(0.4), test::streetPose(0.8)});
  PointSelector selector;
  Keyframe& keyframe = window->keyframe(1);
  for (const Pixel& pixel : selector.select(keyframe.left.level(0), wanted, 6)) {
    ImmaturePoint point;
    point.u = static_cast<float>(pixel.u);
    point.v = static_cast<float>(pixel.v);
    point.inverse_depth = factor * static_cast<float>(test::streetInverseDepth(
                                       keyframe.T_world_camera(), pixel.u, pixel.v));
    point.sigma = 0.05F * point.inverse_depth;
    point.has_depth = true;
    point.pattern = patternAt(keyframe.left.level(0), pixel.u, pixel.v);
    keyframe.immature.push_back(point);
  }
  return window;
}

std::vector<PairGeometry> allPairs(const Window& window) {
  std::vector<PairGeometry> pairs(kSlots * kSlots);
  for (const int host : window.order()) {
    for (const int target : window.order()) {
      if (host == target) continue;
      pairs[static_cast<std::size_t>(host * kSlots + target)] =
          pairGeometry(test::streetRig().pinhole, window.keyframe(host), window.keyframe(target));
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("a place is taken once within the spacing") {
  Occupancy occupancy;
  occupancy.reset(100, 50, 10);
  CHECK(occupancy.claim(50, 25));
  CHECK_FALSE(occupancy.claim(50, 25));
  CHECK_FALSE(occupancy.claim(57, 31));
  CHECK(occupancy.claim(61, 25));
  CHECK(occupancy.claim(0, 0));
  CHECK(occupancy.claim(99.5F, 49.5F));
  occupancy.reset(100, 50, 10);
  CHECK(occupancy.claim(50, 25));
}

TEST_CASE("a candidate's depth is refined over all keyframes") {
  const auto window = withCandidates(1.03F);
  const auto pairs = allPairs(*window);
  int refined = 0;
  double before = 0;
  double after = 0;
  for (const ImmaturePoint& candidate : window->keyframe(1).immature) {
    const auto point = refineCandidate(test::streetRig(), {1.0F}, *window, 1, pairs, candidate);
    if (!point) continue;
    const double truth = candidate.inverse_depth / 1.03;
    ++refined;
    before += std::abs(candidate.inverse_depth - truth) / truth;
    after += std::min(0.2, std::abs(point->inverse_depth - truth) / truth);
    CHECK(point->information > 100);
  }
  CHECK(refined > 150);
  CHECK(after < 0.6 * before);
}

TEST_CASE("a candidate that no other image confirms is refused") {
  const auto window = withCandidates(1);
  for (const int slot : {0, 2}) {
    window->keyframe(slot).left.level(0) =
        test::levelOf(480, 200, [](int u, int v) { return (u * v) % 251; });
  }
  const auto pairs = allPairs(*window);
  int refined = 0;
  for (const ImmaturePoint& candidate : window->keyframe(1).immature) {
    refined += refineCandidate(test::streetRig(), {1.0F}, *window, 1, pairs, candidate) ? 1 : 0;
  }
  CHECK(refined < 20);
}

TEST_CASE("what only the right camera can confirm is taken from it") {
  auto window = withCandidates(1);
  window->remove(0);
  window->remove(2);
  const auto pairs = allPairs(*window);
  int with_right = 0;
  int without = 0;
  for (const ImmaturePoint& candidate : window->keyframe(1).immature) {
    const auto refine = [&](float lambda) {
      return refineCandidate(test::streetRig(), {lambda}, *window, 1, pairs, candidate).has_value();
    };
    with_right += refine(1) ? 1 : 0;
    without += refine(0) ? 1 : 0;
  }
  CHECK(with_right > 150);
  CHECK(without >= with_right);  // without the static term there is nothing to contradict it
}

TEST_CASE("activation fills the window evenly and no further than wanted") {
  const auto window = withCandidates(1, 900);
  const std::size_t offered = window->keyframe(1).immature.size();
  Activator activator;
  activator.activate(test::streetRig(), {1.0F}, 150, *window);
  const std::vector<Point>& points = window->keyframe(1).points;
  CHECK(points.size() > 60);
  CHECK(points.size() < offered / 2);
  CHECK(window->keyframe(1).immature.size() < offered);
  for (const Point& a : points) {
    int near = 0;
    for (const Point& b : points) near += std::hypot(a.u - b.u, a.v - b.v) < 4 ? 1 : 0;
    CHECK(near == 1);  // itself
  }
}

TEST_CASE("candidates that are vague wait, those that failed or left the view are dropped") {
  const auto window = withCandidates(1);
  std::vector<ImmaturePoint>& immature = window->keyframe(1).immature;
  const std::size_t offered = immature.size();
  for (std::size_t i = 0; i < offered; ++i) {
    if (i % 3 == 0) immature[i].sigma = 10;
    if (i % 3 == 1) immature[i].failures = 3;
  }
  Activator activator;
  activator.activate(test::streetRig(), {1.0F}, 1000, *window);
  CHECK(immature.size() <= offered / 3 + 1 + offered / 3);
  for (const ImmaturePoint& point : immature) CHECK(point.failures < 3);
  CHECK(window->keyframe(1).points.size() <= offered / 3 + 1);
}
