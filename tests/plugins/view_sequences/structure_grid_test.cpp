// SPDX-License-Identifier: BSD-3-Clause
// Grids of structure: which cell a point is in, levels, turning by 180 degrees, the mean.
#include "structure_grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "part_state.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

std::size_t cellOf(int lateral, int along, int height) {
  return static_cast<std::size_t>((lateral * kAlong + along) * kHeights + height);
}

StructureLevels levelsOf(const std::vector<Eigen::Vector3f>& points) {
  StructureCounts counts;
  for (const Eigen::Vector3f& point : points) counts.add(point);
  return counts.levels();
}

std::vector<Eigen::Vector3f> somePoints(RandomStream& random, int count) {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(static_cast<float>(random.uniform(-15, 15)),
                        static_cast<float>(random.uniform(-8, 1.2)),
                        static_cast<float>(random.uniform(-11, 11)));
  }
  return points;
}

StructureLevels someLevels(RandomStream& random) {
  StructureLevels levels;
  for (std::uint8_t& level : levels) level = static_cast<std::uint8_t>(random.below(16));
  return levels;
}

}  // namespace

TEST_CASE("a point is counted in its cell, and nowhere else") {
  const auto only = [](const Eigen::Vector3f& point) {
    const StructureLevels levels = levelsOf({point});
    std::vector<std::size_t> filled;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (levels[i] > 0) filled.push_back(i);
    }
    return filled;
  };
  using Cells = std::vector<std::size_t>;
  // The camera is in the middle of the middle column and on the edge of two rows, 1.65 m up.
  CHECK(only({0, 0, 0.1F}) == Cells{cellOf(10, 8, 1)});
  CHECK(only({0, 0, -0.1F}) == Cells{cellOf(10, 7, 1)});
  CHECK(only({0.8F, 0, 0.1F}) == Cells{cellOf(11, 8, 1)});
  CHECK(only({-15.7F, 1, -11.9F}) == Cells{cellOf(0, 0, 0)});
  CHECK(only({15.7F, -20, 11.9F}) == Cells{cellOf(20, 15, 5)});
  CHECK(only({0, -1, 0.1F}) == Cells{cellOf(10, 8, 2)});
  CHECK(only({0, -3, 0.1F}) == Cells{cellOf(10, 8, 3)});
  CHECK(only({0, -5, 0.1F}) == Cells{cellOf(10, 8, 4)});
  for (const Eigen::Vector3f& outside :
       {Eigen::Vector3f(16, 0, 0), Eigen::Vector3f(-16, 0, 0), Eigen::Vector3f(0, 0, 12.1F),
        Eigen::Vector3f(0, 0, -12.1F), Eigen::Vector3f(0, 1.5F, 0), Eigen::Vector3f(0, -29, 0)}) {
    CHECK(only(outside).empty());
    StructureCounts counts;
    counts.add(outside);
    CHECK(counts.points() == 0);
  }
}

TEST_CASE("levels are logarithms of numbers, at most 15") {
  for (const int count : {0, 1, 2, 5, 20, 100, 1000, 5000}) {
    StructureCounts counts;
    for (int i = 0; i < count; ++i) counts.add({0, 0, 1});
    CAPTURE(count);
    CHECK(counts.points() == count);
    CHECK(counts.levels()[cellOf(10, 8, 1)] ==
          std::min(15L, std::lround(2 * std::log(1.0 + count))));
  }
}

TEST_CASE("turned is what a camera in the other direction counts, and twice turned is nothing") {
  RandomStream random(1);
  const std::vector<Eigen::Vector3f> points = somePoints(random, 3000);
  std::vector<Eigen::Vector3f> seen_turned;
  for (const auto& p : points) seen_turned.emplace_back(-p.x(), p.y(), -p.z());
  const StructureMean none;
  const StructureDeviation here = none.deviationOf(levelsOf(points));
  CHECK(turned(here) == none.deviationOf(levelsOf(seen_turned)));
  CHECK(turned(here) != here);
  CHECK(turned(turned(here)) == here);
}

TEST_CASE("the mean is that of all grids, and what they share is no deviation") {
  RandomStream random(2);
  StructureMean mean;
  std::vector<double> sums(kCells, 0.0);
  StructureLevels last{};
  for (int n = 1; n <= 200; ++n) {
    last = someLevels(random);
    mean.add(last);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += last[i];
    if (n % 50 != 1) continue;
    for (std::size_t i = 0; i < sums.size(); i += 37) {
      CHECK(mean.mean()[i] == Approx(sums[i] / n).margin(1e-3));
      CHECK(mean.deviationOf(last)[i] == Approx(last[i] - sums[i] / n).margin(1e-3));
    }
  }
  StructureMean same;
  for (int n = 0; n < 30; ++n) same.add(last);
  for (const float deviation : same.deviationOf(last)) REQUIRE(std::abs(deviation) < 1e-4);
}

TEST_CASE("a mean is loaded to the bit; a damaged one is refused") {
  RandomStream random(3);
  StructureMean mean;
  for (int n = 0; n < 9; ++n) mean.add(someLevels(random));
  const std::string bytes = savedBytes([&](StateWriter& writer) { mean.save(writer); });
  const auto takes = [](StructureMean& into, const std::string& state) {
    StateReader reader = readerOf(state);
    return into.load(reader) && reader.complete();
  };
  StructureMean loaded;
  REQUIRE(takes(loaded, bytes));
  const StructureLevels next = someLevels(random);
  mean.add(next);
  loaded.add(next);
  CHECK(loaded.mean() == mean.mean());
  CHECK_FALSE(takes(loaded, bytes.substr(0, bytes.size() - 1)));
  CHECK_FALSE(takes(loaded, overwritten(bytes, 0, std::int64_t{-1})));
  CHECK_FALSE(takes(loaded, overwritten(bytes, 12, NAN)));
  CHECK_FALSE(takes(loaded, overwritten(bytes, 12, 15.5F)));
}
