// SPDX-License-Identifier: BSD-3-Clause
// Costs along paths against the equation of path_cost.hpp, evaluated one view at a time.
#include "path_cost.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "part_state.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

constexpr PathCostSettings kSettings = {0.9, 0.8, 1.2};

/// E_t(p) = z_t(p) + offset + memory * min(0, best of all ways that lead to p).
class Naive {
 public:
  explicit Naive(Direction direction) : forwards_(direction == Direction::Forwards) {}
  void add(std::int64_t predecessor) {
    const auto view = static_cast<std::int64_t>(cost_.size());
    continues_.push_back(predecessor >= 0 && predecessor == view - 1);
    if (predecessor >= 0 && predecessor != view - 1) join(predecessor, view);
    cost_.push_back(0);
  }
  void join(std::int64_t from, std::int64_t to) { links_.emplace_back(from, to); }
  void step(const std::vector<float>& z, double advance, std::int64_t candidates) {
    std::vector<double> next;
    for (std::int64_t p = 0; p < static_cast<std::int64_t>(cost_.size()); ++p) {
      double best = 0;
      std::int64_t from = p;
      for (int k = 0; k <= 3; ++k) {  // at most three views in one step
        best = std::min(best, at(from) + kSettings.penalty * std::abs(k - advance));
        if (!hasBefore(from)) break;
        from += forwards_ ? -1 : 1;
      }
      for (const auto& [first, second] : links_) {
        const auto [source, target] =
            forwards_ ? std::pair(first, second) : std::pair(second, first);
        if (target != p || source >= candidates) continue;
        best = std::min(best, at(source) + kSettings.penalty * std::abs(1 - advance));
      }
      next.push_back(z[static_cast<std::size_t>(p)] + kSettings.offset + kSettings.memory * best);
    }
    cost_ = next;
  }
  double& at(std::int64_t p) { return cost_[static_cast<std::size_t>(p)]; }
  void forget() { cost_.assign(cost_.size(), 0); }

 private:
  /// Whether there is a view before this one in the direction in which the path is driven now.
  bool hasBefore(std::int64_t view) const {
    const auto i = static_cast<std::size_t>(view);
    if (forwards_) return continues_[i];
    return i + 1 < continues_.size() && continues_[i + 1];
  }

  bool forwards_;
  std::vector<double> cost_;
  std::vector<bool> continues_;
  std::vector<std::pair<std::int64_t, std::int64_t>> links_;
};

/// The implementation and the oracle, with the same calls.
struct Pair {
  explicit Pair(Direction direction = Direction::Forwards)
      : cost({kSettings.memory, kSettings.penalty, kSettings.offset, direction}),
        naive(direction) {}

  PathCost cost;
  Naive naive;
  std::int64_t views = 0;

  void add(std::int64_t predecessor) {
    cost.add(predecessor);
    naive.add(predecessor);
    ++views;
  }
  void addSomewhere(RandomStream& random) {
    const std::uint64_t kind = random.below(10);
    const bool alone = views == 0 || kind == 0;
    const auto older =
        static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(views + 1)));
    add(alone ? -1 : (kind == 1 ? std::min(older, views - 1) : views - 1));
  }
  void join(RandomStream& random) {
    const auto any = [&] {
      return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(views)));
    };
    const std::int64_t from = any();
    const std::int64_t to = any();
    cost.join(from, to);
    naive.join(from, to);
  }
  void step(RandomStream& random) {
    std::vector<float> z;
    for (std::int64_t i = 0; i < views; ++i) z.push_back(static_cast<float>(random.normal() - 0.5));
    const double advance = random.uniform(0, 4);
    const auto candidates =
        static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(views + 1)));
    cost.step(z, advance, candidates);
    naive.step(z, advance, candidates);
  }
  void check() {
    REQUIRE(cost.cost().size() == static_cast<std::size_t>(views));
    for (std::int64_t p = 0; p < views; ++p) {
      CAPTURE(p, views);
      REQUIRE(cost.cost()[static_cast<std::size_t>(p)] == Approx(naive.at(p)).margin(1e-4));
    }
  }
};

std::string bytesOf(const PathCost& cost) {
  return savedBytes([&](StateWriter& writer) { cost.save(writer); });
}

bool takes(PathCost& cost, const std::string& bytes, std::int64_t views) {
  StateReader reader = readerOf(bytes);
  return cost.load(reader, views) && reader.complete();
}

Pair somePaths(RandomStream& random) {
  Pair pair;
  for (int i = 0; i < 60; ++i) {
    pair.addSomewhere(random);
    if (i % 9 == 8) pair.join(random);
    pair.step(random);
  }
  return pair;
}

}  // namespace

TEST_CASE("costs are those of the equation, over random paths, links, steps and candidates") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed);
    Pair pair(seed % 2 == 0 ? Direction::Forwards : Direction::Backwards);
    for (int i = 0; i < 120; ++i) {
      if (random.below(3) != 0) pair.addSomewhere(random);
      if (pair.views == 0) continue;
      if (random.below(12) == 0) pair.join(random);
      if (random.below(15) == 0) {
        const auto view = static_cast<std::int64_t>(random.below(std::uint64_t(pair.views)));
        const auto change = static_cast<float>(random.normal());
        pair.cost.correct(view, change);
        pair.naive.at(view) += change;
      }
      if (random.below(40) == 0) {
        pair.cost.forget();
        pair.naive.forget();
      }
      pair.step(random);
      pair.check();
    }
  }
}

TEST_CASE("the cost falls along a path that is driven again at its own speed") {
  PathCost cost(kSettings);
  for (int i = 0; i < 40; ++i) cost.add(i - 1);
  for (int t = 0; t < 10; ++t) {
    std::vector<float> z(40, 0);
    z[static_cast<std::size_t>(10 + t)] = -3;
    cost.step(z, 1, 40);
  }
  const auto all = cost.cost();
  CHECK(std::ranges::min_element(all) - all.begin() == 19);
  double expected = 0;
  for (int t = 0; t < 10; ++t) expected = -3 + 1.2 + 0.9 * expected;
  CHECK(all[19] == Approx(expected));
  CHECK(all[39] == Approx(1.2));  // nothing was alike, and a cost above 0 counts as 0
  cost.forget();
  for (const float e : cost.cost()) CHECK(e == 0);
}

TEST_CASE("the cost falls in reverse order along a path that is driven the other way") {
  constexpr PathCostSettings kBack = {0.9, 0.8, 1.2, Direction::Backwards};
  for (const auto direction : {Direction::Backwards, Direction::Forwards}) {
    PathCost cost({kBack.memory, kBack.penalty, kBack.offset, direction});
    for (int i = 0; i < 40; ++i) cost.add(i - 1);
    for (int t = 0; t < 10; ++t) {
      std::vector<float> z(40, 0);
      z[static_cast<std::size_t>(30 - t)] = -3;
      cost.step(z, 1, 40);
    }
    double expected = 0;
    for (int t = 0; t < 10; ++t) expected = -3 + 1.2 + 0.9 * expected;
    if (direction == Direction::Backwards) {
      CHECK(cost.cost()[21] == Approx(expected));
    } else {
      CHECK(cost.cost()[21] > 0.5 * expected);
    }
    CHECK(cost.cost()[0] == Approx(1.2));
  }
}

TEST_CASE("a loaded state is the saved one to the bit, and goes on as it would") {
  RandomStream random(31);
  Pair pair = somePaths(random);
  PathCost loaded(kSettings);
  loaded.add(-1);  // forgotten
  REQUIRE(takes(loaded, bytesOf(pair.cost), pair.views));
  CHECK(bytesOf(loaded) == bytesOf(pair.cost));
  for (int i = 0; i < 20; ++i) {
    pair.cost.add(pair.views - 1);
    loaded.add(pair.views - 1);
    ++pair.views;
    std::vector<float> z(static_cast<std::size_t>(pair.views), -1.5F);
    pair.cost.step(z, 1.1, pair.views);
    loaded.step(z, 1.1, pair.views);
    REQUIRE(bytesOf(loaded) == bytesOf(pair.cost));
  }
  PathCost empty(kSettings);
  CHECK(takes(empty, bytesOf(PathCost(kSettings)), 0));
}

TEST_CASE("damaged states are refused without asking for memory") {
  RandomStream random(32);
  const Pair pair = somePaths(random);
  const std::string sound = bytesOf(pair.cost);
  const auto isRefused = [&](const std::string& bytes, std::int64_t views) {
    PathCost cost(kSettings);
    return !takes(cost, bytes, views);
  };
  REQUIRE_FALSE(isRefused(sound, pair.views));
  for (std::size_t length = 0; length < sound.size(); length += 7) {
    CAPTURE(length);
    REQUIRE(isRefused(sound.substr(0, length), pair.views));
  }
  CHECK(isRefused(sound, pair.views - 1));
  CHECK(isRefused(sound, pair.views + 1));
  CHECK(isRefused(sound, INT64_MAX / 8));
  CHECK(isRefused(overwritten(sound, 4, NAN), pair.views));
  CHECK(isRefused(overwritten(sound, 4, INFINITY), pair.views));
  const std::size_t starts_at = 4 * static_cast<std::size_t>(pair.views);
  CHECK(isRefused(overwritten(sound, starts_at, std::uint64_t{1} << 60U), pair.views));
  CHECK(isRefused(overwritten(sound, starts_at + 8, std::int64_t{1}), pair.views));  // not from 0
  CHECK(isRefused(overwritten(sound, starts_at + 16, pair.views), pair.views));
  CHECK(isRefused(overwritten(sound, starts_at + 16, std::int64_t{-1}), pair.views));
  CHECK(isRefused(overwritten(sound, starts_at + 16, std::int64_t{0}), pair.views));  // twice
  CHECK(isRefused(overwritten(sound, sound.size() - 8, pair.views), pair.views));     // a link
  CHECK(isRefused(overwritten(sound, sound.size() - 16, std::int64_t{-1}), pair.views));
}
