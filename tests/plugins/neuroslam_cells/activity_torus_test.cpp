// SPDX-License-Identifier: BSD-3-Clause
// The block of cells compared with sums over all cells, computed here without separation of axes.
#include "activity_torus.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <tolman/context.hpp>

using namespace tolman;
using namespace tolman::neuroslam_cells;

namespace {

constexpr std::array<int, 3> kSizes = {9, 11, 10};

ActivityTorus randomTorus(std::uint64_t seed) {
  RandomStream random(seed);
  ActivityTorus torus(kSizes);
  for (int k = 0; k < 30; ++k) {
    torus.add({static_cast<double>(random.below(9)), static_cast<double>(random.below(11)),
               static_cast<double>(random.below(10))},
              static_cast<float>(random.uniform()));
  }
  return torus;
}

template <class Do>
void forEachCell(const Do& visit) {
  std::array<int, 3> cell;
  for (cell[2] = 0; cell[2] < kSizes[2]; ++cell[2]) {
    for (cell[1] = 0; cell[1] < kSizes[1]; ++cell[1]) {
      for (cell[0] = 0; cell[0] < kSizes[0]; ++cell[0]) visit(cell);
    }
  }
}

/// The kernel's weight at a distance of whole cells.
float weight(const std::vector<float>& kernel, int off) {
  const auto radius = static_cast<int>(kernel.size() / 2);
  return std::abs(off) > radius ? 0 : kernel[static_cast<std::size_t>(off + radius)];
}

double spreadTo(const ActivityTorus& torus, const std::vector<float>& kernel,
                const std::array<int, 3>& to) {
  double sum = 0;
  forEachCell([&](const std::array<int, 3>& from) {
    double product = torus.at(from);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      product *= weight(kernel, static_cast<int>(torus.away(axis, from[axis], to[axis])));
    }
    sum += product;
  });
  return sum;
}

}  // namespace

TEST_CASE("a kernel is a Gaussian that adds up to one") {
  const std::vector<float> kernel = gaussianKernel(7, 1.5);
  REQUIRE(kernel.size() == 7);
  CHECK(std::accumulate(kernel.begin(), kernel.end(), 0.0F) == Approx(1));
  CHECK(kernel[0] == kernel[6]);
  CHECK(kernel[4] / kernel[3] == Approx(std::exp(-0.5 / 2.25)));
}

TEST_CASE(
    "the attractor is excitation less inhibition, less a constant, not negative, of total 1") {
  ActivityTorus torus = randomTorus(1);
  const std::vector<float> narrow = gaussianKernel(5, 1);
  const std::vector<float> wide = gaussianKernel(7, 2.5);
  ActivityTorus excited(kSizes);
  forEachCell([&](const std::array<int, 3>& cell) {
    excited.add(
        {static_cast<double>(cell[0]), static_cast<double>(cell[1]), static_cast<double>(cell[2])},
        static_cast<float>(spreadTo(torus, narrow, cell)));
  });
  std::vector<double> expected;
  forEachCell([&](const std::array<int, 3>& cell) {
    expected.push_back(std::max(0.0, excited.at(cell) - spreadTo(excited, wide, cell) - 1e-3));
  });
  const double total = std::accumulate(expected.begin(), expected.end(), 0.0);
  torus.attract(narrow, wide, 1e-3F);
  CHECK(torus.total() == Approx(1));
  for (std::size_t k = 0; k < expected.size(); ++k) {
    REQUIRE(torus.values()[k] == Approx(expected[k] / total).margin(1e-5));
  }
}

TEST_CASE("a shift by whole cells moves every cell, round the edges too") {
  const ActivityTorus before = randomTorus(2);
  ActivityTorus after = before;
  after.shift({-4, 25, 3});
  forEachCell([&](const std::array<int, 3>& cell) {
    REQUIRE(after.at({cell[0] - 4, cell[1] + 25, cell[2] + 3}) == before.at(cell));
  });
}

TEST_CASE("a shift by parts of a cell moves the centre by as much and keeps the total") {
  ActivityTorus torus({15, 15, 15});
  torus.add({7, 7, 7}, 0.6F);
  torus.add({8, 7, 6}, 0.4F);
  const CellPlace before = torus.peak(4);
  torus.shift({0.3, -1.6, 2.45});
  const CellPlace after = torus.peak(4);
  CHECK(torus.total() == Approx(1));
  CHECK(torus.away(0, before[0], after[0]) == Approx(0.3).margin(0.03));
  CHECK(torus.away(1, before[1], after[1]) == Approx(-1.6).margin(0.03));
  CHECK(torus.away(2, before[2], after[2]) == Approx(2.45).margin(0.03));
}

TEST_CASE("the peak is a population vector round the strongest cell, also over an edge") {
  ActivityTorus torus({12, 12, 1});
  torus.add({11, 3, 0}, 1);
  torus.add({0, 3, 0}, 0.9F);
  torus.add({5, 9, 0}, 0.5F);  // far away: does not count
  const CellPlace place = torus.peak(2);
  CHECK(place[0] == Approx(11 + 0.9 / 1.9).margin(0.02));
  CHECK(place[1] == Approx(3).margin(1e-6));
  CHECK(place[2] == 0);
}

TEST_CASE("a silent block stays silent") {
  ActivityTorus torus(kSizes);
  torus.attract(gaussianKernel(5, 1), gaussianKernel(5, 2), 1e-3F);
  CHECK(torus.total() == 0);
}
