// SPDX-License-Identifier: BSD-3-Clause
// Distances of the present view to stored ones, against sums in double over all pairs of cells.
#include <catch2/catch.hpp>
#include <cmath>

#include "place_search.hpp"
#include "random_views.hpp"
#include "view_bank.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

struct Stored {
  ViewBank bank;
  std::vector<EdgeValues> views;
};

Stored storedPath(int views, RandomStream& random) {
  Stored stored;
  stored.views = randomPath(views, random);
  for (std::size_t i = 0; i < stored.views.size(); ++i) {
    stored.bank.add(packedLevels(stored.views[i]), static_cast<double>(i));
  }
  return stored;
}

std::array<std::int16_t, kValues> levelsFor(const EdgeValues& view) {
  std::array<std::int16_t, kValues> levels;
  unpack(packedLevels(view), levels);
  return levels;
}

/// 1 - cosine, where cell (c, r) of now lies on cell (c + shift, r) of the stored view. The stored
/// view's norm over the overlap is its share of the norm over all cells.
double naiveDistance(const EdgeValues& now, const EdgeValues& mean, const EdgeValues& stored,
                     const Chunk& chunk, int shift) {
  double product = 0;
  double squares = 0;
  double squares_stored = 0;
  int overlap = 0;
  for (int c = 0; c < kColumns; ++c) {
    for (int i = 0; i < kColumnValues; ++i) {
      const auto all = static_cast<std::size_t>(c * kColumnValues + i);
      const double whole = stored[all] - chunk.mean[all] / kMeanScale;
      squares_stored += whole * whole;
      if (c + shift < 0 || c + shift >= kColumns) continue;
      const auto on = static_cast<std::size_t>((c + shift) * kColumnValues + i);
      const double a = now[all] - mean[all];
      const double b = stored[on] - chunk.mean[on] / kMeanScale;
      product += a * b;
      squares += a * a;
      ++overlap;
    }
  }
  return 1 - product / std::sqrt(squares * squares_stored * overlap / kValues);
}

EdgeValues meanOf(const std::vector<EdgeValues>& views) {
  EdgeValues mean{};
  for (std::size_t k = 0; k < kValues; ++k) {
    for (const EdgeValues& view : views) mean[k] += view[k];
    mean[k] /= static_cast<float>(views.size());
  }
  return mean;
}

}  // namespace

TEST_CASE("distances of all shifts are those of plain sums in double") {
  RandomStream random(1);
  const Stored stored = storedPath(150, random);
  const EdgeValues mean = meanOf(stored.views);
  for (int trial = 0; trial < 40; ++trial) {
    const auto i = static_cast<std::size_t>(random.below(150));
    // Alike, unlike, or moved.
    EdgeValues now = randomLevels(random);
    if (trial % 3 == 1) now = withNoise(stored.views[i], 2, random);
    if (trial % 3 == 2) now = movedLeft(stored.views[i], trial % 7 - 3, random);
    const ViewQuery query(now, mean);
    const Chunk& chunk = stored.bank.chunks()[i / 64];
    const auto view = static_cast<std::int64_t>(i);
    const auto levels = levelsFor(stored.views[i]);
    const auto products = query.productsWith(chunk);
    const auto found = query.distances(levels, products, stored.bank.deviation(view));
    double least = 3;
    for (int s = 0; s < kShifts; ++s) {
      const double naive = naiveDistance(now, mean, stored.views[i], chunk, s - kShift);
      CAPTURE(trial, s - kShift);
      REQUIRE(found[static_cast<std::size_t>(s)] == Approx(naive).margin(0.002));
      least = std::min(least, naive);
    }
    const ViewDistance best = query.distanceTo(levels, products, stored.bank.deviation(view));
    CHECK(best.distance == Approx(least).margin(0.002));
    CHECK(found[static_cast<std::size_t>(best.shift + kShift)] == best.distance);
  }
}

TEST_CASE("a view that moved is alike at its shift, and only there") {
  RandomStream random(2);
  const Stored stored = storedPath(64, random);
  const EdgeValues mean = meanOf(stored.views);
  for (int cells = -kShift; cells <= kShift; ++cells) {
    const ViewQuery query(movedLeft(stored.views[20], cells, random), mean);
    const Chunk& chunk = stored.bank.chunks()[0];
    const auto products = query.productsWith(chunk);
    const auto levels = levelsFor(stored.views[20]);
    const ViewDistance best = query.distanceTo(levels, products, stored.bank.deviation(20));
    CAPTURE(cells);
    CHECK(best.shift == cells);
    CHECK(best.distance < 0.45);
    for (const float other : query.distances(levels, products, stored.bank.deviation(20))) {
      CHECK((other == best.distance || other > 0.6));
    }
    CHECK(shiftOf(query, stored.bank, 20).moved_left == Approx(cells).margin(0.3));
    CHECK(shiftOf(query, stored.bank, 20).distance == best.distance);
  }
}

TEST_CASE("the same view has distance 0, its opposite 2, and a view without deviation 1") {
  RandomStream random(3);
  const Stored stored = storedPath(1, random);  // its own mean: no deviation
  Chunk chunk;
  chunk.count = 1;
  for (std::size_t k = 0; k < kValues; ++k) chunk.mean[k] = 8 * 16;
  const EdgeValues mean = [] {
    EdgeValues eights;
    eights.fill(8);
    return eights;
  }();
  EdgeValues view;
  EdgeValues opposite;
  double squares = 0;
  for (std::size_t k = 0; k < kValues; ++k) {
    const auto away = static_cast<float>(random.below(15)) - 7;
    view[k] = 8 + away;
    opposite[k] = 8 - away;
    squares += away * away;
  }
  const auto norm = static_cast<float>(std::sqrt(squares));
  const auto levels = levelsFor(view);
  const auto centre = static_cast<std::size_t>(kShift);
  const ViewQuery same(view, mean);
  CHECK(same.distances(levels, same.productsWith(chunk), norm)[centre] == Approx(0).margin(1e-4));
  const ViewQuery other(opposite, mean);
  CHECK(other.distances(levels, other.productsWith(chunk), norm)[centre] == Approx(2).margin(1e-4));
  const ViewQuery blank(mean, mean);
  for (const float d : blank.distances(levels, blank.productsWith(chunk), norm)) CHECK(d == 1);
  for (const float d : same.distances(levels, same.productsWith(chunk), 0)) CHECK(d == 1);
  CHECK(shiftOf(same, stored.bank, 0).distance == 1);
}

TEST_CASE("between two cells the shift is interpolated, and its sign is that of the movement") {
  // A soft pattern that can move by parts of a cell.
  const auto soft = [](double moved_left) {
    EdgeValues view;
    for (int c = 0; c < kColumns; ++c) {
      for (int i = 0; i < kColumnValues; ++i) {
        const double x = c + moved_left;
        const double level =
            7.5 + 3.5 * std::sin(0.9 * x + 2.1 * i) + 3 * std::sin(0.55 * x - 1.3 * i) + 0.02 * i;
        view[static_cast<std::size_t>(c * kColumnValues + i)] =
            static_cast<float>(std::clamp(std::round(level), 0.0, 15.0));
      }
    }
    return view;
  };
  RandomStream random(4);
  ViewBank bank;
  std::vector<EdgeValues> views = {soft(0)};
  for (int i = 0; i < 30; ++i) views.push_back(randomLevels(random));
  for (const EdgeValues& view : views) bank.add(packedLevels(view), 0);
  EdgeValues mean = meanOf(views);
  double before = -10;
  for (const double moved : {-2.3, -2.0, -1.4, -0.7, -0.3, 0.0, 0.25, 0.5, 1.0, 1.6, 2.4}) {
    const MeasuredShift shift = shiftOf(ViewQuery(soft(moved), mean), bank, 0);
    CAPTURE(moved);
    CHECK(shift.moved_left == Approx(moved).margin(0.35));
    CHECK(shift.moved_left > before);
    before = shift.moved_left;
  }
}

TEST_CASE("the mean of the pass does not count: another light on all views changes nothing") {
  RandomStream random(5);
  const Stored stored = storedPath(64, random);
  const EdgeValues mean = meanOf(stored.views);
  EdgeValues brighter = stored.views[9];
  EdgeValues mean_of_brighter = mean;
  for (std::size_t k = 0; k < kValues; ++k) {
    const auto more = static_cast<float>(random.uniform(-4, 4));
    brighter[k] += more;
    mean_of_brighter[k] += more;
  }
  const MeasuredShift plain = shiftOf(ViewQuery(stored.views[9], mean), stored.bank, 9);
  const MeasuredShift lit = shiftOf(ViewQuery(brighter, mean_of_brighter), stored.bank, 9);
  CHECK(plain.distance == Approx(0).margin(0.01));
  CHECK(lit.distance == Approx(plain.distance).margin(0.002));
}
