// SPDX-License-Identifier: BSD-3-Clause
// The separable attractor, which skips empty rows, compared with the plain triple sum.
#include <activity_volume.hpp>
#include <catch2/catch.hpp>
#include <numbers>
#include <tolman/context.hpp>
#include <tolman/geometry.hpp>

using namespace tolman;

namespace {

constexpr int kSide = 11;
constexpr int kHeadings = 9;

ActivityVolume randomVolume(std::uint64_t seed, int cells) {
  RandomStream random(seed);
  ActivityVolume volume(kSide, kSide, kHeadings);
  for (int i = 0; i < cells; ++i) {
    volume.add(static_cast<int>(random.below(kSide)), static_cast<int>(random.below(kSide)),
               static_cast<int>(random.below(kHeadings)), static_cast<float>(random.uniform()));
  }
  return volume;
}

/// What the neighbours of one cell send to it, by the full 3-D kernel.
double received(const ActivityVolume& volume, const std::vector<float>& kernel, int x, int y,
                int theta) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  const auto weight = [&](int k) {
    return static_cast<double>(kernel[static_cast<std::size_t>(k + radius)]);
  };
  double sum = 0;
  for (int k = -radius; k <= radius; ++k) {
    for (int j = -radius; j <= radius; ++j) {
      for (int i = -radius; i <= radius; ++i) {
        sum += weight(i) * weight(j) * weight(k) *
               static_cast<double>(volume.at(x - i, y - j, theta - k));
      }
    }
  }
  return sum;
}

template <class Check>
void forAllCells(Check&& check) {
  for (int theta = 0; theta < kHeadings; ++theta) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) check(x, y, theta);
    }
  }
}

}  // namespace

TEST_CASE("kernels are even, peak in the middle and add up to one") {
  const std::vector<float> kernel = gaussianKernel(7, 1);
  float sum = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    sum += kernel[i];
    CHECK(kernel[i] == kernel[6 - i]);
    CHECK(kernel[i] <= kernel[3]);
  }
  CHECK(sum == Approx(1));
  CHECK(kernel[2] / kernel[3] == Approx(std::exp(-0.5)));
}

TEST_CASE("excitation and inhibition are the full 3-D convolution, round all three corners") {
  const auto kernel = gaussianKernel(GENERATE(1, 3, 5, 7), 1.7);
  for (const int cells : {1, 20, 2000}) {
    const ActivityVolume before = randomVolume(5, cells);
    ActivityVolume excited = before;
    ActivityVolume inhibited = before;
    excited.excite(kernel);
    inhibited.inhibit(kernel);
    forAllCells([&](int x, int y, int theta) {
      const double expected = received(before, kernel, x, y, theta);
      CHECK(excited.at(x, y, theta) == Approx(expected).margin(1e-6));
      CHECK(inhibited.at(x, y, theta) ==
            Approx(static_cast<double>(before.at(x, y, theta)) - expected).margin(1e-6));
    });
  }
}

TEST_CASE("global inhibition stops at zero, normalising makes the total one") {
  ActivityVolume volume = randomVolume(6, 50);
  const ActivityVolume before = volume;
  volume.inhibitAll(0.3F);
  forAllCells([&](int x, int y, int theta) {
    CHECK(volume.at(x, y, theta) == std::max(0.0F, before.at(x, y, theta) - 0.3F));
  });
  volume.normalise();
  CHECK(volume.total() == Approx(1));
  ActivityVolume empty(kSide, kSide, kHeadings);
  empty.normalise();
  CHECK(empty.total() == 0);
}

TEST_CASE("path integration moves the packet by the distance, however far in one step") {
  // RatSLAM's weights turn negative beyond one cell a step (defect 10).
  for (const double step : {0.3, 1.0, 2.7, -1.4, 25.0}) {
    ActivityVolume volume(30, 30, 36);
    for (int k = -1; k <= 1; ++k) volume.add(15 + k, 15, 9, 1);  // heading 90 deg
    volume.normalise();
    volume.move(step, 0);
    const CellPose peak = volume.peak(3);
    CHECK(volume.distance(peak, {15, 15 + step, 9}) < 1e-3);
    CHECK(volume.total() == Approx(1).epsilon(1e-5));
    for (const float value : volume.values()) REQUIRE(value >= 0);
  }
}

TEST_CASE("a turn moves the packet round the ring, also backwards and more than once") {
  for (const double turn : {0.25, 3.5, -7.75, 40.0}) {
    ActivityVolume volume(11, 11, 36);
    volume.add(5, 5, 2, 1);
    volume.turn(turn);
    CHECK(volume.distance(volume.peak(3), {5, 5, wrapPeriod(2 + turn, 36)}) < 0.02);
    CHECK(volume.total() == Approx(1));
  }
}

TEST_CASE("sideways motion and the layers' own headings") {
  ActivityVolume volume(30, 30, 36);
  volume.add(15, 15, 18, 1);  // facing -x
  volume.move(2, 1);          // forward is -x, left is -y
  CHECK(volume.distance(volume.peak(3), {13, 14, 18}) < 1e-3);
}

TEST_CASE("the packet is stable: it keeps place and size for hundreds of steps") {
  ActivityVolume volume(30, 30, 36);
  volume.add(3, 28, 35, 1);
  const auto excitation = gaussianKernel(7, 1);
  const auto inhibition = gaussianKernel(5, 2);
  for (int step = 0; step < 300; ++step) {
    volume.attract(excitation, inhibition, 2e-5F);
  }
  CHECK(volume.distance(volume.peak(3), {3, 28, 35}) < 1e-3);
  std::size_t active = 0;
  for (const float value : volume.values()) active += value > 0 ? 1 : 0;
  CHECK(active > 20);
  CHECK(active < 400);
}

TEST_CASE("distance goes the short way on all axes") {
  const ActivityVolume volume(20, 20, 36);
  CHECK(volume.distance({19, 1, 35}, {1, 19, 1}) == Approx(std::sqrt(4.0 + 4.0 + 4.0)));
  CHECK(volume.distance({0, 0, 0}, {10, 0, 0}) == Approx(10));
}

TEST_CASE("all layers of a block with axes of unlike length shift alike, by parts of a cell too") {
  ActivityVolume volume(15, 13, 11);
  volume.add(7, 6, 5, 0.6F);
  volume.add(8, 6, 4, 0.4F);
  const CellPose before = volume.peak(4);
  volume.shift(0.3, -1.6, 2.45);
  const CellPose after = volume.peak(4);
  CHECK(volume.total() == Approx(1));
  CHECK(after.x - before.x == Approx(0.3).margin(0.03));
  CHECK(after.y - before.y == Approx(-1.6).margin(0.03));
  CHECK(after.theta - before.theta == Approx(2.45).margin(0.03));
  volume.shift(-4.3, 25.6, 3.55);  // far round the edges
  CHECK(volume.distance(volume.peak(4), {before.x - 4, before.y + 24, before.theta + 6}) < 0.05);
}

TEST_CASE("with one layer a block is a sheet: its peak is over an edge, and kernels keep it") {
  ActivityVolume volume(12, 12, 1);
  volume.add(11, 3, 0, 1);
  volume.add(0, 3, 0, 0.9F);
  volume.add(5, 9, 0, 0.5F);  // far away: does not count
  const CellPose place = volume.peak(2);
  CHECK(place.x == Approx(11 + 0.9 / 1.9).margin(0.02));
  CHECK(place.y == Approx(3).margin(1e-6));
  CHECK(place.theta == 0);
  volume.excite(gaussianKernel(5, 1));
  CHECK(volume.total() == Approx(2.4));
}
