// SPDX-License-Identifier: BSD-3-Clause
// The mirrored drive has the opposite turns and the same lengths.
#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::scanline;
using namespace tolman::scanline::test;

namespace {

Image mirrored(const Image& image) {
  return gray(image.width(), image.height(),
              [&](int x, int y) { return image.row(y)[image.width() - 1 - x]; });
}

}  // namespace

TEST_CASE("a mirrored drive has turns of the other sign and the same ways") {
  for (const CameraRig& rig : {pinholeRig(), unknownRig()}) {
    RandomStream random(4);
    Host plain(rig, whole());
    Host reflected(rig, whole());
    REQUIRE(plain.configured().isOk());
    REQUIRE(reflected.configured().isOk());
    double yaw = 0;
    int turned = 0;
    for (int i = 0; i < 40; ++i) {
      yaw += random.uniform(-0.12, 0.12);
      const Image image = view(rig, yaw, 1.4);
      const Motion a = plain.see(image);
      const Motion b = reflected.see(mirrored(image));
      CAPTURE(rig.calibrated, i, yaw);
      REQUIRE(a.state == b.state);
      REQUIRE(a.v == Approx(b.v).margin(1e-5));
      REQUIRE(a.omega == Approx(-b.omega).margin(1e-4));
      const PlanarPose here = toPlanar(a.T_previous_current);
      const PlanarPose there = toPlanar(b.T_previous_current);
      REQUIRE(here.x == Approx(there.x).margin(1e-6));
      REQUIRE(here.y == Approx(-there.y).margin(1e-6));
      REQUIRE((a.covariance.diagonal() - b.covariance.diagonal()).norm() < 1e-6);
      turned += std::abs(a.omega) > 0.1;
    }
    CHECK(turned > 20);
  }
}

TEST_CASE("negatives and other exposures show the same turns") {
  const CameraRig rig = unknownRig();
  RandomStream random(5);
  Host plain(rig, whole());
  Host negative(rig, whole());
  Host dim(rig, whole());
  double yaw = 0;
  for (int i = 0; i < 30; ++i) {
    yaw += random.uniform(-0.1, 0.1);
    const Image image = view(rig, yaw, 1.4);
    const auto changed = [&](auto&& grey) {
      return gray(rig.width, rig.height, [&](int x, int y) { return grey(image.row(y)[x]); });
    };
    const Motion a = plain.see(image);
    const Motion b = negative.see(changed([](int grey) { return 255 - grey; }));
    const Motion c = dim.see(changed([](int grey) { return grey / 2 + 40; }));
    CAPTURE(i, yaw);
    REQUIRE(a.omega == Approx(b.omega).margin(1e-3));
    REQUIRE(a.omega == Approx(c.omega).margin(0.02));
  }
}
