// SPDX-License-Identifier: BSD-3-Clause
// The window during a drive: size, points, depths, gauge.
#include "mapper.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "harness.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

/// A pixel at column u of the image comes to u + errors(u, v), by linear interpolation.
Image displaced(const Image& image, const std::function<double(double, double)>& errors) {
  return Image::create(image.width(), image.height(), PixelFormat::Gray8, [&](std::uint8_t* data) {
    for (int v = 0; v < image.height(); ++v) {
      for (int u = 0; u < image.width(); ++u) {
        const double from = std::clamp(u - errors(u, v), 0.0, image.width() - 1.001);
        const int left = static_cast<int>(from);
        const double part = from - left;
        const double value = (1 - part) * image.row(v)[left] + part * image.row(v)[left + 1];
        *data++ = static_cast<std::uint8_t>(value + 0.5);
      }
    }
  });
}

struct MapperCase {
  CameraRig rig = test::streetRig();
  MapperSettings settings;
  Mapper mapper;

  MapperCase() {
    settings.points = 500;
    settings.candidates = 500;
    settings.window = 4;
    mapper.configure(rig, settings);
  }
  /// The right image is displaced to the right by `errors(u, v)` px, if there are any.
  void keyframe(int index, const Eigen::Isometry3d& pose, bool covered = false,
                const std::function<double(double, double)>& errors = {}) {
    Frame frame = test::streetFrame(index, pose);
    if (errors) frame.right = displaced(frame.right, errors);
    ImagePyramid left;
    ImagePyramid right;
    left.build(frame.left);
    if (!covered) right.build(frame.right, 1);
    mapper.addKeyframe(index, pose, Affine(), left, right);
  }
};

double depthError(const Window& window) {
  std::vector<double> errors;
  for (const int slot : window.order()) {
    const Keyframe& keyframe = window.keyframe(slot);
    for (const Point& p : keyframe.points) {
      const double truth = test::streetInverseDepth(keyframe.T_world_camera(), p.u, p.v);
      errors.push_back(std::abs(p.inverse_depth - truth) / truth);
    }
  }
  std::nth_element(errors.begin(), errors.begin() + std::ptrdiff_t(errors.size() / 2),
                   errors.end());
  return errors[errors.size() / 2];
}

}  // namespace

TEST_CASE("the first keyframe has points from static stereo at once, and holds the gauge") {
  MapperCase c;
  c.keyframe(0, test::streetPose(3));
  CHECK(c.mapper.window().size() == 1);
  CHECK(c.mapper.window().pointCount() > 100);
  CHECK(depthError(c.mapper.window()) < 0.02);
  CHECK(c.mapper.window().newest().T_world_camera().isApprox(test::streetPose(3), 1e-6));
}

TEST_CASE("a drive: the window stays at its size, the poses stay true") {
  MapperCase c;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Isometry3d pose = test::streetPose(0.5 * k);
    c.keyframe(k, pose);
    const Window& window = c.mapper.window();
    CHECK(window.size() == std::min(k + 1, 4));
    CHECK(window.newest().frame == k);
    CHECK(window.pointCount() > 100);
    CHECK(window.pointCount() < 1000);
    CHECK((window.newest().T_world_camera().translation() - pose.translation()).norm() < 0.01);
  }
  CHECK(depthError(c.mapper.window()) < 0.02);
  CHECK(c.mapper.window().prior.H.allFinite());
}

TEST_CASE("a covered right camera leaves a keyframe whose candidates wait for motion") {
  MapperCase c;
  c.keyframe(0, test::streetPose(0));
  c.keyframe(1, test::streetPose(0.5), true);
  const Keyframe& covered = c.mapper.window().newest();
  CHECK_FALSE(covered.has_right);
  CHECK(covered.points.empty());
  REQUIRE_FALSE(covered.immature.empty());
  for (const ImmaturePoint& point : covered.immature) CHECK_FALSE(point.has_depth);
  for (int k = 1; k < 4; ++k) {
    const Eigen::Isometry3d pose = test::streetPose(0.5 + 0.15 * k);
    c.mapper.observe(pose, Affine(), test::streetPyramid(pose));
  }
  int found = 0;
  for (const ImmaturePoint& point : covered.immature) found += point.has_depth ? 1 : 0;
  CHECK(found > 50);
}

TEST_CASE("gain and offset of the right camera are measured from the matches") {
  MapperCase c;
  const Frame frame = test::streetFrame(0, test::streetPose(0));
  ImagePyramid left;
  ImagePyramid right;
  left.build(frame.left);
  right.build(test::changed(frame.right, 0.85, 7), 1);
  c.mapper.addKeyframe(0, test::streetPose(0), Affine(), left, right);
  const Keyframe& newest = c.mapper.window().newest();
  for (const float level : {60.0F, 125.0F, 200.0F}) {
    CHECK(newest.right_gain * level + newest.right_offset == Approx(0.85F * level + 7).margin(4));
  }
  CHECK(depthError(c.mapper.window()) < 0.02);
}

TEST_CASE("reset equals fresh") {
  MapperCase c;
  c.keyframe(0, test::streetPose(0));
  c.keyframe(1, test::streetPose(0.5));
  c.mapper.reset();
  CHECK(c.mapper.window().empty());
  c.keyframe(0, test::streetPose(0));
  MapperCase fresh;
  fresh.keyframe(0, test::streetPose(0));
  const auto& a = c.mapper.window().newest().points;
  const auto& b = fresh.mapper.window().newest().points;
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].inverse_depth == b[i].inverse_depth);
}

namespace {

/// The field after a drive of ten keyframes with these errors of columns.
DisparityField fieldAfterDrive(const std::function<double(double, double)>& errors) {
  MapperCase c;
  c.settings.offset_sigma = 1;
  c.settings.column_sigma = 0.3;
  c.settings.calibration_distance = 4;
  c.mapper.configure(c.rig, c.settings);
  for (int k = 0; k < 10; ++k) c.keyframe(k, test::streetPose(0.5 * k), false, errors);
  return c.mapper.window().field;
}

}  // namespace

TEST_CASE("exact cameras have no field of disparity errors") {
  const DisparityField field = fieldAfterDrive({});
  CHECK_FALSE(field.isOn());
  CHECK(std::abs(field.offset()) < 0.05);
}

TEST_CASE("smooth errors of the columns are found") {
  const double width = test::streetRig().width;
  const double height = test::streetRig().height;
  const auto errors = [&](double u, double v) {
    return 0.8 * (2 * u / width - 1) * (2 * v / height - 1);
  };
  const DisparityField field = fieldAfterDrive(errors);
  REQUIRE(field.isOn());
  for (const double u : {80.0, 400.0}) {
    for (const double v : {40.0, 160.0}) {
      CHECK(field.at(u, v, 0) == Approx(errors(u, v)).margin(0.2));
    }
  }
}

TEST_CASE("a turned camera has an offset, which is not compensated, and no field") {
  const CameraRig rig = test::streetRig();
  constexpr double kYaw = 0.4 / 300;  // 0.4 px at the centre
  const auto errors = [&](double u, double) {
    const double x = u - rig.pinhole.cx;
    return kYaw * (rig.pinhole.fx + x * x / rig.pinhole.fx);
  };
  const DisparityField field = fieldAfterDrive(errors);
  CHECK_FALSE(field.isOn());
  for (const double disparity : {0.0, 40.0}) {
    CHECK(field.at(240, 100, disparity) == Approx(0.4).margin(0.08));
    CHECK(field.at(20, 100, disparity) == Approx(errors(20, 100)).margin(0.12));
  }
}
