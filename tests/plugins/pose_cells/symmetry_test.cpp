// SPDX-License-Identifier: BSD-3-Clause
// All operations on the volume of pose cells, a torus, commute with shifts and mirroring of a
// packet.
#include <activity_volume.hpp>
#include <algorithm>
#include <catch2/catch.hpp>

#include "tolman/context.hpp"

using namespace tolman;

namespace {

constexpr int kTorusSide = 12;
constexpr int kTorusHeadings = 10;

int wrapped(int value, int count) { return ((value % count) + count) % count; }

ActivityVolume randomVolume(RandomStream& random) {
  ActivityVolume volume(kTorusSide, kTorusSide, kTorusHeadings);
  for (int i = 0; i < 25; ++i) {
    volume.add(
        static_cast<int>(random.below(kTorusSide)), static_cast<int>(random.below(kTorusSide)),
        static_cast<int>(random.below(kTorusHeadings)), static_cast<float>(random.uniform()));
  }
  return volume;
}

/// Every cell of `volume` at the place that `to(x, y, theta)` says.
template <class To>
ActivityVolume rearranged(const ActivityVolume& volume, const To& to) {
  ActivityVolume result(kTorusSide, kTorusSide, kTorusHeadings);
  for (int theta = 0; theta < kTorusHeadings; ++theta) {
    for (int y = 0; y < kTorusSide; ++y) {
      for (int x = 0; x < kTorusSide; ++x) {
        const std::array<int, 3> place = to(x, y, theta);
        result.add(wrapped(place[0], kTorusSide), wrapped(place[1], kTorusSide),
                   wrapped(place[2], kTorusHeadings), volume.at(x, y, theta));
      }
    }
  }
  return result;
}

void requireSame(const ActivityVolume& a, const ActivityVolume& b) {
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    REQUIRE(a.values()[i] == Approx(b.values()[i]).margin(1e-5));
  }
}

std::array<int, 3> mirrored(int x, int y, int theta) { return {x, -y, -theta}; }

}  // namespace

TEST_CASE("the dynamics do not know where on the torus a packet is") {
  RandomStream random(3);
  const std::vector<float> narrow = gaussianKernel(5, 1);
  const std::vector<float> wide = gaussianKernel(7, 2);
  for (int round = 0; round < 10; ++round) {
    const int dx = static_cast<int>(random.below(kTorusSide));
    const int dy = static_cast<int>(random.below(kTorusSide));
    const int dtheta = static_cast<int>(random.below(kTorusHeadings));
    const auto shift = [&](int x, int y, int theta) {
      return std::array<int, 3>{x + dx, y + dy, theta + dtheta};
    };
    ActivityVolume here = randomVolume(random);
    ActivityVolume there = rearranged(here, shift);
    const double turn = random.uniform(-3, 3);
    for (ActivityVolume* volume : {&here, &there}) {
      volume->excite(narrow);
      volume->inhibit(wide);
      volume->inhibitAll(0.001F);
      volume->normalise();
      volume->turn(turn);
    }
    requireSame(rearranged(here, shift), there);
    const CellPose a = here.peak(3);
    const CellPose b = there.peak(3);
    CHECK(here.distance({a.x + dx, a.y + dy, a.theta + dtheta}, b) == Approx(0).margin(1e-3));
  }
}

TEST_CASE("path integration is the same everywhere in the plane") {
  RandomStream random(4);
  for (int round = 0; round < 10; ++round) {
    const int dx = static_cast<int>(random.below(kTorusSide));
    const int dy = static_cast<int>(random.below(kTorusSide));
    const auto shift = [&](int x, int y, int theta) {
      return std::array<int, 3>{x + dx, y + dy, theta};
    };
    ActivityVolume here = randomVolume(random);
    ActivityVolume there = rearranged(here, shift);
    const double forward = random.uniform(-4, 4);
    const double left = random.uniform(-2, 2);
    here.move(forward, left);
    there.move(forward, left);
    requireSame(rearranged(here, shift), there);
  }
}

TEST_CASE("a mirrored packet moves and turns as the mirror image does") {
  RandomStream random(5);
  const std::vector<float> kernel = gaussianKernel(5, 1);
  for (int round = 0; round < 10; ++round) {
    ActivityVolume plain = randomVolume(random);
    ActivityVolume reflected = rearranged(plain, mirrored);
    for (int step = 0; step < 5; ++step) {
      const double forward = random.uniform(-2, 3);
      const double left = random.uniform(-1, 1);
      const double turn = random.uniform(-1.5, 1.5);
      plain.move(forward, left);
      plain.turn(turn);
      plain.excite(kernel);
      reflected.move(forward, -left);
      reflected.turn(-turn);
      reflected.excite(kernel);
    }
    requireSame(rearranged(plain, mirrored), reflected);
  }
}

TEST_CASE("neither motion nor turns make or swallow activity") {
  RandomStream random(6);
  for (int round = 0; round < 20; ++round) {
    ActivityVolume volume = randomVolume(random);
    const float before = volume.total();
    volume.move(random.uniform(-30, 30), random.uniform(-30, 30));
    volume.turn(random.uniform(-40, 40));
    volume.excite(gaussianKernel(7, 1.5));
    const auto least = *std::min_element(volume.values().begin(), volume.values().end());
    CHECK(volume.total() == Approx(before).epsilon(1e-4));
    CHECK(least >= 0);
  }
}
