// SPDX-License-Identifier: BSD-3-Clause
// Comparison of grids in opposite directions, against cosines in double precision.
#include <catch2/catch.hpp>
#include <cmath>

#include "opposite_grids.hpp"
#include "structure_grid.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

/// The same by its definition: cells (lateral, along, height) of the query, seen from the other
/// side, lie on those of the stored grid that are `side` to the right and `front` further on.
double cosineAt(const StructureLevels& query, const StructureLevels& stored,
                const StructureDeviation& mean, int side, int front) {
  double products = 0;
  double a = 0;
  double b = 0;
  for (int i = 0; i < kLateral; ++i) {
    for (int j = 0; j < kAlong; ++j) {
      const int to_i = kLateral - 1 - i + side;
      const int to_j = kAlong - 1 - j + front;
      if (to_i < 0 || to_i >= kLateral || to_j < 0 || to_j >= kAlong) continue;
      for (int k = 0; k < kHeights; ++k) {
        const auto from = static_cast<std::size_t>((i * kAlong + j) * kHeights + k);
        const auto to = static_cast<std::size_t>((to_i * kAlong + to_j) * kHeights + k);
        const double x = query[from] - mean[from];
        const double y = stored[to] - mean[to];
        products += x * y;
        a += x * x;
        b += y * y;
      }
    }
  }
  return products / std::sqrt(a * b);
}

StructureMean someMean(RandomStream& random) {
  StructureMean mean;
  for (int n = 0; n < 20; ++n) mean.add(randomGrid(random));
  return mean;
}

}  // namespace

TEST_CASE("the distance is that of the best shift to the side, by its definition") {
  RandomStream random(11);
  const StructureMean mean = someMean(random);
  for (int n = 0; n < 20; ++n) {
    const StructureLevels a = randomGrid(random);
    const StructureLevels b = randomGrid(random);
    double best = -1;
    for (int side = -kStructureShift; side <= kStructureShift; ++side) {
      best = std::max(best, cosineAt(a, b, mean.mean(), side, 0));
    }
    CHECK(StructureQuery(a, mean).distanceTo(b) == Approx(1 - best).margin(2e-3));
  }
}

TEST_CASE("a street is like itself the other way, from another lane, and like no other") {
  RandomStream random(12);
  const StructureMean mean = someMean(random);
  for (int lane = -kStructureShift; lane <= kStructureShift; ++lane) {
    const StructureLevels street = randomGrid(random);
    const StructureQuery back(seenTurned(street, lane, 0), mean);
    CAPTURE(lane);
    CHECK(back.distanceTo(street) < 0.1F);
    CHECK(back.distanceTo(randomGrid(random)) > 0.7F);
    CHECK(StructureQuery(street, mean).distanceTo(street) > 0.7F);  // not the other way
  }
}

TEST_CASE("a grid that is the mean, or empty, is like nothing") {
  RandomStream random(13);
  StructureMean mean;
  const StructureLevels street = randomGrid(random);
  mean.add(street);
  CHECK(StructureQuery(street, mean).distanceTo(randomGrid(random)) >= 0.9F);
  CHECK(std::isfinite(StructureQuery(street, mean).distanceTo(street)));
  const StructureMean none;
  CHECK(StructureQuery(StructureLevels{}, none).distanceTo(street) == 2);
  CHECK(fitStructure(StructureDeviation{}, none.deviationOf(street)).correlation == -1);
}

TEST_CASE("the fit finds where the camera stands, in cells of 1.5 m") {
  RandomStream random(14);
  const StructureMean mean = someMean(random);
  for (int side : {-5, -2, 0, 3, 5}) {
    for (int front : {-3, -1, 0, 2, 3}) {
      const StructureLevels street = randomGrid(random);
      const StructureDeviation query = turned(mean.deviationOf(seenTurned(street, side, front)));
      const StructureFit fit = fitStructure(query, mean.deviationOf(street));
      CAPTURE(side, front);
      CHECK(fit.within);
      CHECK(fit.correlation > 0.9);
      CHECK(fit.lateral == Approx(1.5 * side).margin(0.15));
      CHECK(fit.ahead == Approx(1.5 * front).margin(0.15));
    }
  }
  const StructureLevels street = randomGrid(random);
  const StructureDeviation far = turned(mean.deviationOf(seenTurned(street, 6, 0)));
  CHECK_FALSE(fitStructure(far, mean.deviationOf(street)).within);
  const StructureDeviation ahead = turned(mean.deviationOf(seenTurned(street, 0, -4)));
  CHECK_FALSE(fitStructure(ahead, mean.deviationOf(street)).within);
}

TEST_CASE("the peak of a parabola") {
  const auto parabola = [](double x) { return 3 - 0.7 * (x - 0.3) * (x - 0.3); };
  CHECK(peakOf(parabola(-1), parabola(0), parabola(1)) == Approx(0.3));
  CHECK(peakOf(1, 1, 1) == 0);
}
