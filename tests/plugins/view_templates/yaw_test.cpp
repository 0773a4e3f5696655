// SPDX-License-Identifier: BSD-3-Clause
// The relative yaw in a synthetic scene, for known turns of the camera.
#include <catch2/catch.hpp>

#include "harness.hpp"
#include "matcher.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

PlaceObservation afterTurn(const ParameterValues& parameters, const Image& before,
                           const Image& after, double focal = 0) {
  ViewTemplates plugin;
  tolman::test::TestContext services(parameters);
  services.rig.calibrated = focal > 0;
  services.rig.pinhole.fx = focal;
  REQUIRE(plugin.configure(services).isOk());
  CHECK(observe(plugin, before).recognition == Recognition::Novel);
  return observe(plugin, after, 1);
}

}  // namespace

TEST_CASE("a turn to the left is positive and of the right size") {
  // 620 px over 81.6 deg; a cell of 8 px (of 8.7) is 1.3 deg, five of them 6.5 deg.
  const double focal = focalOfFieldOfView(81.6 * std::numbers::pi / 180, 620);
  const double degrees = GENERATE(-6.0, -3.3, -1.0, 0.0, 0.5, 2.0, 5.0);
  const double yaw = degrees * std::numbers::pi / 180;
  const PlaceObservation seen = afterTurn({{"threshold", 0.12}}, pinholeView(620, 188, focal, 0.7),
                                          pinholeView(620, 188, focal, 0.7 + yaw));
  CHECK(seen.recognition == Recognition::Familiar);
  CHECK(seen.relative_yaw == Approx(yaw).margin(0.6 * std::numbers::pi / 180));  // half a cell
}

TEST_CASE("the calibration goes before field_of_view") {
  const Image before = pinholeView(620, 188, 300, 0.7);
  const Image after = pinholeView(620, 188, 300, 0.7 + 0.05);
  const auto seen = afterTurn({{"threshold", 0.12}}, before, after, 300);
  CHECK(seen.relative_yaw == Approx(0.05).margin(0.015));
  const auto wide = afterTurn({{"threshold", 0.12}}, before, after, 150);
  CHECK(std::tan(wide.relative_yaw) == Approx(2 * std::tan(seen.relative_yaw)));
}

TEST_CASE("a panorama turns all the way round") {
  const auto cylinder = [](double yaw) {
    return gray(720, 100, [=](int x, int y) {
      const double azimuth = yaw - 2 * std::numbers::pi * x / 720;
      return std::lround(panorama(azimuth, 0.005 * (50 - y)));
    });
  };
  const ParameterValues parameters = {{"panoramic", true},
                                      {"crop", std::vector<double>{0, 1, 50.0 / 376, 300.0 / 376}},
                                      {"threshold", 0.1}};
  const double yaw = GENERATE(-3.0, -1.5, 0.0, 0.31, 2.2, 3.1);
  const PlaceObservation seen = afterTurn(parameters, cylinder(0.4), cylinder(0.4 + yaw));
  CHECK(seen.recognition == Recognition::Familiar);
  CHECK(wrapAngle(seen.relative_yaw - yaw) == Approx(0).margin(0.03));  // a cell is 0.105
}

TEST_CASE("yaw of a shift, by hand") {
  CHECK(focalOfFieldOfView(std::numbers::pi / 2, 640) == Approx(320));
  CHECK(yawOfPinholeShift(320, 320) == Approx(std::numbers::pi / 4));
  CHECK(yawOfPanoramicShift(15, 60) == Approx(std::numbers::pi / 2));
  CHECK(yawOfPanoramicShift(45, 60) == Approx(-std::numbers::pi / 2));
}
