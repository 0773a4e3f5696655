// SPDX-License-Identifier: BSD-3-Clause
// Rectified cameras against the definition of rectification: rows and disparities of points.
#include "engine/rectified_view.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "engine/pixel_map.hpp"
#include "engine/raw_cameras.hpp"
#include "support/gray_images.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::engine;

namespace {

RectifiedView viewOf(const RawRig& rig, const ViewOptions& options = {}) {
  const auto view = chooseView(rig, options);
  INFO(view.status().message());
  REQUIRE(view.isOk());
  return view.value();
}

/// Where the rectified camera sees a point of the reference frame.
Eigen::Vector3d inRectified(const RawRig& rig, const RectifiedView& view, std::size_t camera,
                            const Eigen::Vector3d& point) {
  return view.R_rectified_raw[camera] * (rig.cameras[camera].T_reference_camera.inverse() * point);
}

std::string refusalOf(const RawRig& rig) { return chooseView(rig, {}).status().message(); }

}  // namespace

TEST_CASE("points lie in one row of both rectified images, with the disparity of their depth") {
  const RawCamera camera = GENERATE(test::eurocCamera(), test::fisheyeCamera(),
                                    test::omnidirectionalCamera(), test::rationalCamera());
  const RawRig rig = test::pairOf(camera, 0.11, {0.02, -0.05, 0.03});
  const RectifiedView view = viewOf(rig);
  const Pinhole& K = view.rig.pinhole;
  CHECK(view.rig.baseline == Approx(0.11).epsilon(1e-3));
  RandomStream random(7);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d point(random.uniform(-2, 2), random.uniform(-1, 1),
                                random.uniform(3, 20));
    const Eigen::Vector3d left = inRectified(rig, view, 0, point);
    const Eigen::Vector3d right = inRectified(rig, view, 1, point);
    CHECK(K.project(left).y() == Approx(K.project(right).y()).margin(1e-9));
    CHECK(K.project(left).x() - K.project(right).x() ==
          Approx(K.fx * view.rig.baseline / left.z()).margin(1e-9));
  }
}

TEST_CASE("the view is filled, and shows most of what both cameras show") {
  const RawCamera camera = GENERATE(test::eurocCamera(), test::fisheyeCamera(),
                                    test::omnidirectionalCamera(), test::rationalCamera());
  const RawRig rig = test::pairOf(camera, 0.11, {0.01, 0.02, -0.01});
  const RectifiedView view = viewOf(rig);
  CAPTURE(enumName(camera.model), view.rig.width, view.rig.height);
  const Image white = test::gray(camera.width, camera.height, [](int, int) { return 255; });
  for (std::size_t i = 0; i < 2; ++i) {
    const Image image = PixelMap(rig.cameras[i], view.R_rectified_raw[i], view.rig).apply(white);
    for (int y = 0; y < image.height(); ++y) {
      CHECK(std::count(image.row(y), image.row(y) + image.width(), std::uint8_t{0}) == 0);
    }
  }
  const double across = std::atan(view.rig.width / view.rig.pinhole.fx / 2) * 360 / M_PI;
  if (camera.model == LensModel::Equidistant) {
    CHECK(across == Approx(90).margin(0.5));
  } else {
    CHECK(view.rig.width > 0.7 * camera.width);
    CHECK(view.rig.height > 0.7 * camera.height);
  }
}

TEST_CASE("scale and field of view") {
  RawRig rig;
  rig.cameras = {test::fisheyeCamera()};
  const RectifiedView whole = viewOf(rig);
  const RectifiedView half = viewOf(rig, {0.5, 90});
  CHECK(half.rig.pinhole.fx == Approx(whole.rig.pinhole.fx / 2));
  CHECK(half.rig.width == Approx(whole.rig.width / 2.0).margin(1));
  const RectifiedView narrow = viewOf(rig, {1, 60});
  CHECK(narrow.rig.pinhole.fx == whole.rig.pinhole.fx);
  CHECK(narrow.rig.width == Approx(2 * narrow.rig.pinhole.fx * std::tan(M_PI / 6)).margin(1));
  CHECK(viewOf(rig, {1, 140}).rig.width > 1.5 * whole.rig.width);
  CHECK(narrow.rig.baseline == 0);
  CHECK(viewText(rig, whole) ==
        "1 equidistant camera of 1024x1024 px, rectified to 762x762 px, 90 x 90 deg");
}

TEST_CASE("a single pinhole stays as it is, and can be made smaller") {
  RawRig rig;
  rig.cameras = {test::rawCamera(LensModel::RadialTangential, 640, 480, {520, 525, 319, 240}, {})};
  const RectifiedView view = viewOf(rig);
  CHECK(view.is_identity);
  CHECK(view.rig.calibrated);
  CHECK(view.rig.pinhole.fy == 525);
  const RectifiedView half = viewOf(rig, {0.5, 90});
  CHECK_FALSE(half.is_identity);
  CHECK(half.rig.width == 320);
  CHECK(half.rig.pinhole.fx == 260);
  CHECK(half.rig.pinhole.cx == 159.25);  // (319 + 0.5) / 2 - 0.5
}

TEST_CASE("prescribed cameras are taken as they are") {
  RawRig rig = test::pairOf(test::eurocCamera(), 0.11, {0, 0, 0});
  rig.has_rectified = true;
  rig.rectified = {700, 400, true, {430, 430, 350, 200}, 0.11};
  rig.cameras[1].R_rectified_camera = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()).matrix();
  const RectifiedView view = viewOf(rig);
  CHECK(view.rig.width == 700);
  CHECK(view.rig.pinhole.fx == 430);
  CHECK(view.R_rectified_raw[1] == rig.cameras[1].R_rectified_camera);
  rig.cameras[1].R_rectified_camera *= 2;
  CHECK_THAT(refusalOf(rig), Catch::Contains("a prescribed rotation is none"));
}

TEST_CASE("what cannot be rectified is refused with a remedy") {
  const RawRig sound = test::pairOf(test::eurocCamera(), 0.11, {0, 0, 0});
  RawRig rig = sound;
  std::swap(rig.cameras[0].T_reference_camera, rig.cameras[1].T_reference_camera);
  CHECK_THAT(refusalOf(rig), Catch::Contains("exchange the two cameras"));
  rig = sound;
  rig.cameras[1].T_reference_camera.translation() = Eigen::Vector3d(0, 0.2, 0);
  CHECK_THAT(refusalOf(rig), Catch::Contains("0.200 m below"));
  rig.cameras[1].T_reference_camera.translation().setZero();
  CHECK_THAT(refusalOf(rig), Catch::Contains("both cameras are at one place"));
  CHECK_THAT(refusalOf(test::pairOf(test::eurocCamera(), 0.11, {0, 2, 0})),
             Catch::Contains("different directions"));
  rig = sound;
  rig.cameras[0].distortion[0] = -50;  // a coefficient at the wrong place
  CHECK_THAT(refusalOf(rig), Catch::Contains("check the model"));
  rig = sound;
  rig.cameras[0].pinhole.fx = 0;
  CHECK_THAT(refusalOf(rig), Catch::Contains("the left camera has focal lengths of 0"));
  rig = sound;
  rig.cameras.push_back(rig.cameras[0]);
  CHECK_THAT(refusalOf(rig), Catch::Contains("3 cameras; one or two"));
}
