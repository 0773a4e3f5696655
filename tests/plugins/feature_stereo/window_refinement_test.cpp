// SPDX-License-Identifier: BSD-3-Clause
// Window book-keeping and its refinement, on windows whose truth is known.
#include <catch2/catch.hpp>

#include "plugins/feature_stereo/known_window.hpp"
#include "window.hpp"

using namespace tolman;
using namespace tolman::feature_stereo;

TEST_CASE("refinement of perturbed poses and landmarks returns to the truth") {
  Window window = makeWindow(0, 0);
  disturb(window);
  RefinementSettings settings;
  settings.iterations = 30;
  settings.offset_sigma = 0;
  refineWindow(test::streetRig(), settings, window);
  CHECK(worstTranslation(window) < 1e-3);
  CHECK(window.landmarks().size() == 150);
  CHECK(window.keyframes().front().T_world_camera.matrix() == truePose(0).matrix());
}

TEST_CASE("a common error of all disparities is found, and does not scale the motion") {
  RefinementSettings settings;
  settings.iterations = 30;
  settings.offset_drift = 1;
  Window window = makeWindow(0.05, 0.3);
  refineWindow(test::streetRig(), settings, window);
  CHECK(window.disparityOffset() == Approx(0.3).margin(0.05));
  CHECK(worstTranslation(window) < 0.02);

  Window trusting = makeWindow(0.05, 0.3);
  settings.offset_sigma = 0;
  refineWindow(test::streetRig(), settings, trusting);
  CHECK(trusting.disparityOffset() == 0);
  CHECK(worstTranslation(trusting) > 0.02);
}

TEST_CASE("an observation that does not fit is removed, its landmark stays") {
  Window window = makeWindow(0.05, 0);
  window.find(7)->observations[2].pixel.x() += 30;
  RefinementSettings settings;
  settings.iterations = 20;
  refineWindow(test::streetRig(), settings, window);
  REQUIRE(window.find(7) != nullptr);
  CHECK(window.find(7)->observations.size() == 4);
  CHECK(worstTranslation(window) < 0.02);
}

TEST_CASE("the same window gives the same bits, wherever it lies in memory") {
  Window first = makeWindow(0.2, 0.1);
  const std::vector<int> gap(100'003);
  Window second = makeWindow(0.2, 0.1);
  refineWindow(test::streetRig(), {}, first);
  refineWindow(test::streetRig(), {}, second);
  for (std::size_t k = 0; k < first.keyframes().size(); ++k) {
    CHECK(first.keyframes()[k].T_world_camera.matrix() ==
          second.keyframes()[k].T_world_camera.matrix());
  }
  CHECK(first.disparityOffset() == second.disparityOffset());
}

TEST_CASE("dropping the oldest keyframe drops the landmarks that only it saw") {
  Window window;
  window.addKeyframe({0, truePose(0)});
  window.addKeyframe({3, truePose(1)});
  Landmark once;
  once.observations = {{0, StereoPixel::Zero(), true}};
  Landmark twice;
  twice.observations = {{0, StereoPixel::Zero(), true}, {3, StereoPixel::Zero(), true}};
  const std::int64_t lost = window.addLandmark(once);
  const std::int64_t kept = window.addLandmark(twice);
  window.dropOldest();
  CHECK(window.keyframes().size() == 1);
  CHECK(window.find(lost) == nullptr);
  REQUIRE(window.find(kept) != nullptr);
  CHECK(window.find(kept)->observations.size() == 1);
}
