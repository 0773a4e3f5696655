// SPDX-License-Identifier: BSD-3-Clause
// The stored views: means and deviations against plain sums; saved and damaged banks.
#include "view_bank.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "part_state.hpp"
#include "random_views.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

constexpr std::int64_t kChunk = 64;  // views, as in view_bank.hpp

/// Passes of so many views; the views of each pass are brighter than those of the one before.
ViewBank bankOf(const std::vector<int>& passes, std::vector<EdgeValues>& views,
                RandomStream& random, auto&& after_each) {
  ViewBank bank;
  double path = 0;
  for (std::size_t p = 0; p < passes.size(); ++p) {
    if (p > 0) bank.beginPass();
    for (int i = 0; i < passes[p]; ++i) {
      EdgeValues levels = randomLevels(random);
      for (float& level : levels) level = std::min(15.0F, std::round(level / 2) + 2.0F * float(p));
      views.push_back(levels);
      bank.add(packedLevels(levels), path += 0.5);
      after_each(bank);
    }
  }
  return bank;
}

ViewBank bankOf(const std::vector<int>& passes, std::uint64_t seed = 1) {
  RandomStream random(seed);
  std::vector<EdgeValues> views;
  return bankOf(passes, views, random, [](const ViewBank&) {});
}

std::string bytesOf(const ViewBank& bank) {
  return savedBytes([&](StateWriter& writer) { bank.save(writer); });
}

bool takes(ViewBank& bank, const std::string& bytes) {
  StateReader reader = readerOf(bytes);
  return bank.load(reader) && reader.complete();
}

/// The mean that view_bank.hpp promises for chunk `c`: over it and its neighbours of the same pass.
std::array<double, kValues> meanAround(const std::vector<Chunk>& chunks, std::size_t c,
                                       const std::vector<EdgeValues>& views) {
  std::array<double, kValues> sums{};
  double count = 0;
  for (std::size_t near = 0; near < chunks.size(); ++near) {
    const bool next_to = near + 1 == c || near == c || near == c + 1;
    if (!next_to || chunks[near].pass != chunks[c].pass) continue;
    for (std::int64_t i = 0; i < chunks[near].count; ++i) {
      const EdgeValues& view = views[static_cast<std::size_t>(chunks[near].first + i)];
      for (std::size_t k = 0; k < kValues; ++k) sums[k] += view[k];
      count += 1;
    }
  }
  for (double& sum : sums) sum /= count;
  return sums;
}

}  // namespace

TEST_CASE("chunks have at most 64 consecutive views, of one pass each") {
  const ViewBank bank = bankOf({70, 10, 200});
  CHECK(bank.size() == 280);
  const std::vector<std::pair<std::int64_t, std::int64_t>> expected = {
      {64, 0}, {6, 0}, {10, 1}, {64, 2}, {64, 2}, {64, 2}, {8, 2}};
  REQUIRE(bank.chunks().size() == expected.size());
  std::int64_t first = 0;
  for (std::size_t c = 0; c < expected.size(); ++c) {
    CHECK(bank.chunks()[c].first == first);
    CHECK(bank.chunks()[c].count == expected[c].first);
    CHECK(bank.chunks()[c].pass == expected[c].second);
    first += expected[c].first;
  }
  CHECK(bank.path(0) == 0.5);
  CHECK(bank.path(279) == 140);
}

TEST_CASE("means and deviations are those of plain sums, at every size of the bank") {
  RandomStream random(2);
  std::vector<EdgeValues> views;
  const auto check = [&](const ViewBank& bank) {
    if (bank.size() % 41 != 0 && bank.size() < 279) return;
    for (std::size_t c = 0; c < bank.chunks().size(); ++c) {
      const Chunk& chunk = bank.chunks()[c];
      const auto mean = meanAround(bank.chunks(), c, views);
      for (std::size_t k = 0; k < kValues; ++k) {
        REQUIRE(std::abs(chunk.mean[k] / kMeanScale - mean[k]) <= 0.5 / kMeanScale + 1e-5);
      }
      for (std::int64_t i = chunk.first; i < chunk.first + chunk.count; ++i) {
        double squares = 0;
        for (std::size_t k = 0; k < kValues; ++k) {
          const double away = views[static_cast<std::size_t>(i)][k] - mean[k];
          squares += away * away;
        }
        REQUIRE(bank.deviation(i) == Approx(std::sqrt(squares)).margin(0.3));
      }
    }
  };
  const ViewBank bank = bankOf({70, 10, 200}, views, random, check);
  for (std::size_t i = 0; i < views.size(); ++i) {
    REQUIRE(levelsOf(bank.view(static_cast<std::int64_t>(i))) == views[i]);
  }
}

TEST_CASE("a settled chunk never changes, and at most the last two of a pass are unsettled") {
  RandomStream random(3);
  std::vector<EdgeValues> views;
  std::map<std::size_t, std::array<std::uint8_t, kValues>> settled;
  const auto check = [&](const ViewBank& bank) {
    for (const auto& [c, mean] : settled) {
      REQUIRE(bank.isSettled(c));
      REQUIRE(bank.chunks()[c].mean == mean);
    }
    for (std::size_t c = 0; c < bank.chunks().size(); ++c) {
      if (bank.isSettled(c)) settled[c] = bank.chunks()[c].mean;
      CAPTURE(bank.size(), c);
      REQUIRE((bank.isSettled(c) || c + 2 >= bank.chunks().size()));
    }
  };
  bankOf({70, 10, 300, 64, 128, 100, 1, 1, 70}, views, random, check);
}

TEST_CASE("when a pass has ended all its chunks are settled") {
  for (const int views : {1, 63, 64, 65, 100, 128, 129, 200}) {
    ViewBank bank = bankOf({views});
    CAPTURE(views);
    CHECK_FALSE(bank.isSettled(bank.chunks().size() - 1));
    bank.beginPass();
    for (std::size_t c = 0; c < bank.chunks().size(); ++c) CHECK(bank.isSettled(c));
    bank.add(PackedView{}, 1000);
    for (std::size_t c = 0; c + 1 < bank.chunks().size(); ++c) CHECK(bank.isSettled(c));
    CHECK_FALSE(bank.isSettled(bank.chunks().size() - 1));
  }
}

TEST_CASE("a loaded bank is the saved one to the bit, and goes on as it would") {
  for (const std::vector<int>& passes :
       {std::vector<int>{}, {1}, {64}, {100}, {70, 10, 200}, {64, 64, 1}}) {
    ViewBank saved = bankOf(passes);
    ViewBank loaded = bankOf({5}, 9);  // forgotten
    REQUIRE(takes(loaded, bytesOf(saved)));
    CHECK(bytesOf(loaded) == bytesOf(saved));
    RandomStream random(4);
    for (int i = 0; i < 80; ++i) {
      const PackedView view = packedLevels(randomLevels(random));
      saved.add(view, 500 + i);
      loaded.add(view, 500 + i);
    }
    CHECK(bytesOf(loaded) == bytesOf(saved));
    REQUIRE(loaded.chunks().size() == saved.chunks().size());
    for (std::size_t c = 0; c < saved.chunks().size(); ++c) {
      CHECK(loaded.chunks()[c].mean == saved.chunks()[c].mean);
    }
    for (std::int64_t i = 0; i < saved.size(); ++i) {
      REQUIRE(loaded.deviation(i) == saved.deviation(i));
    }
  }
}

TEST_CASE("truncated banks and sizes that the bytes cannot hold are refused") {
  const std::string sound = bytesOf(bankOf({70, 10}));
  for (std::size_t length = 0; length < sound.size(); length += 131) {
    ViewBank bank;
    CAPTURE(length);
    REQUIRE_FALSE(takes(bank, sound.substr(0, length)));
  }
  RandomStream random(5);
  const std::size_t chunks_at = 8 + 80 * (kPackedBytes + sizeof(float));
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const std::size_t fields[] = {0, chunks_at, chunks_at + 8, chunks_at + 24};
    const std::uint64_t wild = ~0ULL >> random.below(50);
    ViewBank bank;
    refused += takes(bank, overwritten(sound, fields[i % 4], wild)) ? 0 : 1;
  }
  CHECK(refused == 200);
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{-1}, kChunk + 1}) {
    ViewBank bank;
    CHECK_FALSE(takes(bank, overwritten(sound, chunks_at + 8, count)));
  }
}

TEST_CASE("wild numbers in a bank are refused: paths that are none, passes out of order") {
  const std::string sound = bytesOf(bankOf({70, 10}));
  const std::size_t paths_at = 8 + 80 * kPackedBytes;
  const std::size_t chunks_at = paths_at + 80 * sizeof(float);
  const auto isRefused = [](const std::string& bytes) {
    ViewBank bank;
    return !takes(bank, bytes);
  };
  CHECK(isRefused(overwritten(sound, paths_at + 4 * 3, NAN)));
  CHECK(isRefused(overwritten(sound, paths_at + 4 * 7, INFINITY)));
  CHECK(isRefused(overwritten(sound, chunks_at + 16, std::int64_t{5})));   // passes 5, 0, 1
  CHECK(isRefused(overwritten(sound, chunks_at + 16, std::int64_t{-1})));  // -1, 0, 1
  CHECK(isRefused(overwritten(sound, sound.size() - 8, INT64_MAX)));       // the pass of now
  CHECK(isRefused(overwritten(sound, sound.size() - 8, std::int64_t{0})));
}
