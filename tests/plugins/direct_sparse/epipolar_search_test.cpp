// SPDX-License-Identifier: BSD-3-Clause
// Inverse depths of candidates, refined by a second view of known pose.
#include "epipolar_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "point_selection.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

struct Views {
  std::unique_ptr<Window> window = test::streetWindow({test::streetPose(0), test::streetPose(0.8)});
  PairGeometry pair =
      pairGeometry(test::streetRig().pinhole, window->keyframe(0), window->keyframe(1));
  std::vector<ImmaturePoint> candidates;

  Views() {
    PointSelector selector;
    const Keyframe& host = window->keyframe(0);
    for (const Pixel& pixel : selector.select(host.left.level(0), 300, 20)) {
      ImmaturePoint point;
      point.u = static_cast<float>(pixel.u);
      point.v = static_cast<float>(pixel.v);
      point.pattern = patternAt(host.left.level(0), pixel.u, pixel.v);
      candidates.push_back(point);
    }
  }
  static float truth(const ImmaturePoint& p) {
    return static_cast<float>(test::streetInverseDepth(test::streetPose(0), p.u, p.v));
  }
  const GrayLevel& image() const { return window->keyframe(1).left.level(0); }
};

}  // namespace

TEST_CASE("a rough depth becomes a better one") {
  Views views;
  int refined = 0;
  int better = 0;
  for (ImmaturePoint& point : views.candidates) {
    const float truth = Views::truth(point);
    point.inverse_depth = 1.25F * truth;
    point.sigma = 0.2F * truth;
    point.has_depth = true;
    const float before = point.sigma;
    observeImmature(views.pair, views.image(), {}, point);
    if (point.sigma == before) continue;
    ++refined;
    CHECK(point.sigma < before);
    better += std::abs(point.inverse_depth - truth) < 0.15F * truth ? 1 : 0;
  }
  CHECK(refined > 50);
  CHECK(10 * better > 9 * refined);
}

TEST_CASE("without any guess the whole line is searched") {
  Views views;
  int found = 0;
  int right = 0;
  for (ImmaturePoint& point : views.candidates) {
    observeImmature(views.pair, views.image(), {}, point);
    if (!point.has_depth) continue;
    ++found;
    right += std::abs(point.inverse_depth - Views::truth(point)) <
                     3 * point.sigma + 0.1F * Views::truth(point)
                 ? 1
                 : 0;
  }
  CHECK(found > 60);
  CHECK(10 * right > 8 * found);
}

TEST_CASE("what could not move a pixel and a half is left alone") {
  Views views;
  ImmaturePoint& point = views.candidates.front();
  point.inverse_depth = Views::truth(point);
  point.sigma = 1e-5F;
  point.has_depth = true;
  const ImmaturePoint before = point;
  observeImmature(views.pair, views.image(), {}, point);
  CHECK(point.inverse_depth == before.inverse_depth);
  CHECK(point.sigma == before.sigma);
  CHECK(point.failures == 0);
  CHECK(point.last_interval < 1.5F);
}

TEST_CASE("a frame that shows something else counts as failures and moves little") {
  Views views;
  const GrayLevel other = test::levelOf(480, 200, [](int u, int v) { return (u * v) % 251; });
  int failures = 0;
  for (ImmaturePoint& point : views.candidates) {
    point.inverse_depth = Views::truth(point);
    point.sigma = 0.2F * point.inverse_depth;
    point.has_depth = true;
    observeImmature(views.pair, other, {}, point);
    failures += point.failures;
  }
  CHECK(failures > static_cast<int>(views.candidates.size()) / 3);
}

TEST_CASE("a brightness change between the frames does not matter when it is known") {
  Views views;
  const GrayLevel& image = views.image();
  const GrayLevel darker = test::levelOf(image.width, image.height, [&](int u, int v) {
    return std::lround(0.7 * image.row(v)[u] + 5);
  });
  views.pair.gain = 0.7F;
  views.pair.target_b = 5;
  int found = 0;
  for (ImmaturePoint& point : views.candidates) {
    point.inverse_depth = 1.2F * Views::truth(point);
    point.sigma = 0.2F * point.inverse_depth;
    point.has_depth = true;
    const float before = point.sigma;
    observeImmature(views.pair, darker, {}, point);
    found += point.sigma < before ? 1 : 0;
  }
  CHECK(found > 50);
}
