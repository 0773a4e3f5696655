// SPDX-License-Identifier: BSD-3-Clause
// Stored grids that are passed in the opposite direction are found in decreasing order. Nothing is
// found on another street, on the recent path, or at the end of the stored path.
#include <catch2/catch.hpp>
#include <cmath>

#include "backward_places.hpp"
#include "opposite_grids.hpp"
#include "part_state.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

/// A street of one grid for each two metres, as the search stores them.
struct Street {
  explicit Street(std::uint64_t seed, int views) {
    RandomStream random(seed);
    for (int i = 0; i < views; ++i) {
      grids.push_back(i % 2 == 0 ? randomGrid(random) : grids.back());
    }
  }
  std::vector<StructureLevels> grids;
};

struct Drive {
  BackwardSearch search{SearchSettings{}};
  StructureMean mean;
  double path = 0;

  /// The view of now is stored and continues the path, unless `begins`.
  void store(const std::optional<StructureLevels>& levels, bool begins = false) {
    search.add(levels, path, begins ? -1 : search.size() - 1);
    path += 1;
  }
  void store(const Street& street) {
    for (std::size_t i = 0; i < street.grids.size(); ++i) {
      mean.add(street.grids[i]);
      store(street.grids[i], i == 0);
    }
  }
  std::optional<PlaceCandidate> see(const StructureLevels& levels) {
    mean.add(levels);
    const StructureQuery query(levels, mean);
    search.step(&query, path, 1);
    path += 1;
    return search.best();
  }
};

std::string bytesOf(const BackwardSearch& search) {
  return savedBytes([&](StateWriter& writer) { search.save(writer); });
}

bool takes(BackwardSearch& search, const std::string& bytes, std::int64_t views) {
  StateReader reader = readerOf(bytes);
  return search.load(reader, views) && reader.complete();
}

}  // namespace

TEST_CASE("a street that is driven back is found after some steps, and followed in falling order") {
  const Street street(1, 120);
  Drive drive;
  drive.store(street);
  drive.path += 50;
  int sure = 0;
  for (int i = 100; i > 20; --i) {
    const auto best = drive.see(seenTurned(street.grids[std::size_t(i)], 2, 0));
    if (!best || best->probability < 0.99) continue;
    ++sure;
    CAPTURE(i, best->view);
    CHECK(std::abs(best->view - i) <= 2);
  }
  CHECK(sure > 70);
}

TEST_CASE("a street that is driven in the same direction, and another one, are not found") {
  const Street street(2, 120);
  for (const bool same : {true, false}) {
    Drive drive;
    drive.store(street);
    drive.path += 50;
    const Street other(3, 120);
    for (int i = 20; i < 100; ++i) {
      const auto best =
          drive.see(same ? street.grids[std::size_t(i)] : other.grids[std::size_t(i)]);
      CAPTURE(same, i);
      if (best) REQUIRE(best->probability < 0.9);
    }
  }
}

TEST_CASE("views of the last 40 m, without structure, or few in number are no places") {
  const Street street(4, 120);
  Drive recent;
  recent.store(street);
  for (int i = 119; i > 110; --i) {
    const auto best = recent.see(seenTurned(street.grids[std::size_t(i)], 0, 0));
    if (best) CHECK(best->view < 90);
  }
  Drive bare;
  for (int i = 0; i < 60; ++i) bare.store(std::nullopt, i == 0);
  bare.path += 50;
  CHECK_FALSE(bare.see(street.grids[0]));
  Drive few;
  for (int i = 0; i < 8; ++i) few.store(street.grids[std::size_t(i)], i == 0);
  few.path += 50;
  for (int i = 7; i >= 0; --i) CHECK_FALSE(few.see(seenTurned(street.grids[std::size_t(i)], 0, 0)));
}

TEST_CASE("where the stored path has no structure any more, nothing is claimed") {
  const Street street(5, 120);
  Drive drive;
  for (int i = 0; i < 120; ++i) {
    drive.store(i < 15 ? std::nullopt : std::optional(street.grids[std::size_t(i)]), i == 0);
  }
  drive.path += 50;
  for (int i = 60; i >= 15; --i) {
    const auto best = drive.see(seenTurned(street.grids[std::size_t(i)], 0, 0));
    if (i < 60 - 15 && i > 22) CHECK(best->view == Approx(i).margin(2));
    if (best) CHECK(best->view >= 20);
  }
}

TEST_CASE("a step without structure sets all costs to 0") {
  const Street street(6, 120);
  Drive drive;
  drive.store(street);
  drive.path += 50;
  for (int i = 100; i > 80; --i) drive.see(seenTurned(street.grids[std::size_t(i)], 0, 0));
  REQUIRE(drive.search.best()->probability > 0.99);
  drive.search.step(nullptr, drive.path, 1);
  CHECK_FALSE(drive.search.best());
  const auto best = drive.see(seenTurned(street.grids[78], 0, 0));
  CHECK((!best || best->probability < 0.9));
}

TEST_CASE("two neighbours share a grid, and the parts of a path do not") {
  const Street street(7, 10);
  Drive drive;
  for (int i = 0; i < 6; ++i) drive.store(street.grids[std::size_t(i)], i == 0 || i == 3);
  const std::string bytes = bytesOf(drive.search);
  std::uint64_t grids = 0;
  std::memcpy(&grids, bytes.data(), sizeof grids);
  CHECK(grids == 4);  // 0+1, 2, 3+4, 5
  CHECK(drive.search.levelsOf(1) == street.grids[0]);
  CHECK(drive.search.levelsOf(3) == street.grids[3]);
  CHECK(drive.search.levelsOf(5) == street.grids[5]);
}

TEST_CASE("with more grids than `exhaustive` the newest are compared") {
  const Street street(8, 400);
  SearchSettings settings;
  settings.exhaustive = 60;
  Drive drive;
  drive.search = BackwardSearch(settings);
  drive.store(street);
  drive.path += 50;
  for (int i = 380; i > 350; --i) drive.see(seenTurned(street.grids[std::size_t(i)], 0, 0));
  CHECK(drive.search.best()->view == Approx(351).margin(2));
  drive.search.step(nullptr, drive.path, 1);
  for (int i = 100; i > 70; --i) {
    const auto best = drive.see(seenTurned(street.grids[std::size_t(i)], 0, 0));
    if (best) CHECK(best->view >= 280);
  }
}

TEST_CASE("a saved search goes on to the bit") {
  const Street street(9, 100);
  Drive drive;
  drive.store(street);
  drive.search.join(50, 10);
  drive.path += 50;
  for (int i = 80; i > 70; --i) drive.see(seenTurned(street.grids[std::size_t(i)], 1, 0));
  Drive loaded = drive;
  loaded.search = BackwardSearch(SearchSettings{});
  REQUIRE(takes(loaded.search, bytesOf(drive.search), 100));
  for (int i = 70; i > 60; --i) {
    const auto a = drive.see(seenTurned(street.grids[std::size_t(i)], 1, 0));
    const auto b = loaded.see(seenTurned(street.grids[std::size_t(i)], 1, 0));
    REQUIRE((a && b));
    CHECK(a->view == b->view);
    CHECK(a->probability == b->probability);
    CHECK(bytesOf(loaded.search) == bytesOf(drive.search));
  }
}

TEST_CASE("damaged searches are refused without asking for memory") {
  const Street street(10, 8);
  Drive drive;
  drive.store(street);
  const std::string sound = bytesOf(drive.search);
  const auto isRefused = [](const std::string& bytes, std::int64_t views) {
    BackwardSearch search{SearchSettings{}};
    return !takes(search, bytes, views);
  };
  REQUIRE_FALSE(isRefused(sound, 8));
  for (std::size_t length = 0; length < sound.size(); length += 97) {
    REQUIRE(isRefused(sound.substr(0, length), 8));
  }
  CHECK(isRefused(sound, 7));
  CHECK(isRefused(sound, 9));
  CHECK(isRefused(sound, INT64_MAX / 64));
  CHECK(isRefused(overwritten(sound, 0, std::uint64_t{1} << 60U), 8));
  CHECK(isRefused(overwritten(sound, 9, std::uint8_t{16}), 8));  // a level
  const std::size_t of_views = 8 + 4 * kCells;
  CHECK(isRefused(overwritten(sound, of_views, std::int32_t{-2}), 8));
  CHECK(isRefused(overwritten(sound, of_views, std::int32_t{2}), 8));
  CHECK(isRefused(overwritten(sound, of_views + 32, INFINITY), 8));  // a path
}
