// SPDX-License-Identifier: BSD-3-Clause
// Profiles against plain column sums, and against the geometry of a turning camera.
#include "profile.hpp"

#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::scanline;
using namespace tolman::scanline::test;

namespace {

Image noise(int width, int height, PixelFormat format, std::uint64_t seed) {
  RandomStream random(seed);
  return Image::create(width, height, format, [&](std::uint8_t* pixels) {
    for (int i = 0; i < width * height * bytesPerPixel(format); ++i) {
      pixels[i] = static_cast<std::uint8_t>(random.below(256));
    }
  });
}

/// The profile between two bearings, as a function.
float sample(const Profile& profile, double at) {
  const auto before = static_cast<std::size_t>(at);
  const auto part = static_cast<float>(at - static_cast<double>(before));
  return (1 - part) * profile[before] + part * profile[before + 1];
}

}  // namespace

TEST_CASE("an uncalibrated profile is the mean of each column, colour the mean of its channels") {
  const PixelFormat format = GENERATE(PixelFormat::Gray8, PixelFormat::Bgr8);
  const int bytes = bytesPerPixel(format);
  const Image image = noise(40, 30, format, 7);
  const ProfileMaker maker(unknownRig(40, 30), {0.25, 0.75, 0.5, 1}, 1.0);
  const Profile profile = maker.make(image);
  REQUIRE(profile.size() == 20);
  CHECK(maker.radiansPerSample() == Approx(1.0 / 40));
  for (int c = 0; c < 20; ++c) {
    double sum = 0;
    for (int r = 15; r < 30; ++r) {
      for (int k = 0; k < bytes; ++k) sum += image.row(r)[(10 + c) * bytes + k];
    }
    CHECK(profile[static_cast<std::size_t>(c)] == Approx(sum / (15.0 * bytes * 255)).margin(1e-6));
  }
}

TEST_CASE("nothing of one image is left in the next") {
  const ProfileMaker maker(unknownRig(40, 30), {}, 1.0);
  const Image second = noise(40, 30, PixelFormat::Gray8, 2);
  const Profile alone = maker.make(second);
  maker.make(noise(40, 30, PixelFormat::Gray8, 1));
  CHECK(maker.make(second) == alone);
}

TEST_CASE("a turn of a pinhole camera shifts the whole profile by one amount") {
  const CameraRig rig = pinholeRig(640, 8, 350);  // sees 85 degrees: the edges count double
  const ProfileMaker maker(rig, {}, 1.0);
  const double turn = 10 * maker.radiansPerSample();  // to the left: the scene goes right
  const Profile before = maker.make(view(rig, 0.3));
  const Profile after = maker.make(view(rig, 0.3 + turn));
  for (const std::size_t i : {20U, 100U, 200U, 320U, 450U, 600U}) {
    CHECK(after[i + 10] == Approx(before[i]).margin(0.01));
  }
  // In the columns of the image the edge moves further than the centre does.
  const double centre = rig.pinhole.fx * turn;
  const double edge = rig.pinhole.fx * (std::tan(0.7 + turn) - std::tan(0.7));
  CHECK(edge > 1.6 * centre);
}

TEST_CASE("equal steps of bearing cover the region and no more") {
  const CameraRig rig = pinholeRig(640, 8, 350);
  const ProfileMaker maker(rig, {0.25, 0.75, 0, 1}, 1.0);
  CHECK(maker.samples() == 320);
  const double seen = std::atan((479 - rig.pinhole.cx) / 350) - std::atan((160 - 319.5) / 350);
  CHECK(maker.radiansPerSample() * 319 == Approx(seen));
  const Profile profile = maker.make(view(rig, 0));
  const double left = std::atan((160 - 319.5) / 350);
  for (const double at : {0.0, 77.5, 200.25}) {
    const double azimuth = -(left + at * maker.radiansPerSample());
    CHECK(sample(profile, at) == Approx(panorama(azimuth) / 255).margin(0.01));
  }
}

TEST_CASE("contrast is the standard deviation") {
  CHECK(contrastOf({}) == 0);
  CHECK(contrastOf({0.5F, 0.5F, 0.5F}) == 0);
  CHECK(contrastOf({0.0F, 1.0F, 0.0F, 1.0F}) == Approx(0.5));
}
