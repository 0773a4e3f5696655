// SPDX-License-Identifier: BSD-3-Clause
// The search on paths of random views: places that are driven again are found, new ones are not.
// Exact probabilities depend on tuning and are not tested.
#include "place_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "edge_grid.hpp"
#include "part_state.hpp"
#include "random_views.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

/// Drives along views, one a metre.
class Drive {
 public:
  explicit Drive(const SearchSettings& settings) : search_(settings) {}

  PlaceSearch& search() { return search_; }
  double path() const { return path_; }
  void beginPass() {
    mean_.beginPass();
    search_.beginPass();
    path_ += 1000;
    at_ = -1;
  }
  /// The places that this view may show.
  std::vector<PlaceCandidate> look(const EdgeValues& view, int most = 3) {
    path_ += 1;
    mean_.add(view);
    search_.step(ViewQuery(view, mean_.mean()), path_, 1);
    return search_.candidates(most);
  }
  void store(const EdgeValues& view) {
    const std::int64_t stored = search_.bank().size();
    search_.add(packedLevels(view), path_, at_);
    at_ = stored;
  }
  void lookAndStore(const std::vector<EdgeValues>& views) {
    for (const EdgeValues& view : views) {
      look(view);
      store(view);
    }
  }

 private:
  PlaceSearch search_;
  MeanView mean_;
  double path_ = 0;
  std::int64_t at_ = -1;
};

constexpr double kNoise = 4;  // levels; the views of a path differ by 3 from what they share

double probabilityOf(const std::vector<PlaceCandidate>& places) {
  return places.empty() ? 0 : places.front().probability;
}

std::string bytesOf(const PlaceSearch& search) {
  return savedBytes([&](StateWriter& writer) { search.save(writer); });
}

}  // namespace

TEST_CASE("a path that is driven again is found at the right views, and a new one is not") {
  RandomStream random(1);
  const std::vector<EdgeValues> street = randomPath(150, random);
  Drive drive({});
  for (const EdgeValues& view : street) {
    CHECK(probabilityOf(drive.look(view)) < 0.5);
    drive.store(view);
  }
  drive.beginPass();
  int right = 0;
  double of_right = 0;
  for (std::size_t i = 0; i < street.size(); ++i) {
    const auto places = drive.look(withNoise(street[i], kNoise, random));
    if (i < 10 || places.empty()) continue;
    right += std::abs(places.front().view - static_cast<std::int64_t>(i)) <= 1 ? 1 : 0;
    of_right += places.front().probability / 140;
  }
  CHECK(right >= 133);
  CHECK(of_right > 0.8);
  drive.beginPass();
  double of_wrong = 0;
  for (const EdgeValues& view : randomPath(150, random)) {
    of_wrong += probabilityOf(drive.look(view)) / 150;
  }
  CHECK(of_wrong < 0.3);
}

TEST_CASE("from anywhere on the path the place is found within a dozen steps, and lost when left") {
  RandomStream random(2);
  const std::vector<EdgeValues> street = randomPath(200, random);
  Drive drive({});
  drive.lookAndStore(street);
  for (const std::size_t start : {0U, 57U, 120U, 180U}) {
    drive.beginPass();
    std::vector<PlaceCandidate> places;
    for (std::size_t i = start; i < start + 12; ++i) {
      places = drive.look(withNoise(street[i], kNoise, random));
    }
    CAPTURE(start);
    REQUIRE_FALSE(places.empty());
    CHECK(std::abs(places.front().view - static_cast<std::int64_t>(start + 11)) <= 1);
    CHECK(places.front().probability > 0.8);
    for (const EdgeValues& view : randomPath(25, random)) places = drive.look(view);
    CHECK(probabilityOf(places) < 0.5);
  }
}

TEST_CASE("places are ordered by probability and more than ten views apart") {
  RandomStream random(3);
  const std::vector<EdgeValues> street = randomPath(200, random);
  Drive drive({});
  drive.lookAndStore(street);
  drive.beginPass();
  std::size_t most_found = 0;
  for (int i = 0; i < 100; ++i) {
    // Now here, now there: several places are likely.
    const std::size_t at = i / 5 % 2 == 0 ? 20 + std::size_t(i) : 60 + std::size_t(i);
    const auto places = drive.look(withNoise(street[at], kNoise, random), 5);
    REQUIRE(places.size() <= 5);
    most_found = std::max(most_found, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      CHECK(places[k].view >= 0);
      CHECK(places[k].view < 200);
      CHECK(places[k].probability >= 0);
      CHECK(places[k].probability <= 1);
      for (std::size_t j = 0; j < k; ++j) {
        CHECK(std::abs(places[k].view - places[j].view) > 10);
      }
      if (k > 0) CHECK(places[k].probability <= places[k - 1].probability);
    }
  }
  CHECK(most_found >= 3);
}

TEST_CASE("views of the last metres are never found, however alike") {
  RandomStream random(4);
  SearchSettings settings;
  settings.recent = 30;
  const std::vector<EdgeValues> street = randomPath(25, random);
  Drive drive(settings);
  drive.lookAndStore(randomPath(60, random));
  for (int lap = 0; lap < 6; ++lap) {  // 25 m each
    for (const EdgeValues& view : street) {
      const auto places = drive.look(view, 5);
      for (const PlaceCandidate& place : places) {
        CAPTURE(lap, place.view);
        CHECK(drive.search().bank().path(place.view) <= drive.path() - 30 + 1e-3);
      }
      drive.store(view);
    }
  }
}

TEST_CASE("as long as there is little to compare with nothing is found") {
  RandomStream random(5);
  Drive drive({});
  const EdgeValues view = randomLevels(random);
  CHECK(drive.look(view).empty());
  drive.store(view);
  drive.beginPass();
  CHECK(drive.look(view).empty());
  CHECK(drive.search().candidates(5).empty());
}

TEST_CASE("the codes' short list finds what the exhaustive search finds, on nearly all steps",
          "[figures]") {
  RandomStream random(6);
  std::vector<EdgeValues> street;
  for (int part = 0; part < 4; ++part) {
    for (const EdgeValues& view : randomPath(300, random)) street.push_back(view);
  }
  SearchSettings all;
  all.exhaustive = 1'000'000;
  SearchSettings short_list;
  short_list.exhaustive = 0;
  Drive exhaustive(all);
  Drive by_codes(short_list);
  for (Drive* drive : {&exhaustive, &by_codes}) {
    drive->lookAndStore(street);
    drive->beginPass();
  }
  int alike = 0;
  int right = 0;
  int steps = 0;
  for (std::size_t i = 400; i < 800; ++i) {
    const EdgeValues view = withNoise(street[i], kNoise, random);
    const auto a = exhaustive.look(view);
    const auto b = by_codes.look(view);
    if (i < 412) continue;
    ++steps;
    REQUIRE_FALSE(a.empty());
    const auto is = [](const std::vector<PlaceCandidate>& places, std::int64_t place) {
      return !places.empty() && std::abs(places.front().view - place) <= 1;
    };
    alike += is(b, a.front().view) ? 1 : 0;
    right += is(b, static_cast<std::int64_t>(i)) ? 1 : 0;
  }
  CHECK(alike > 0.95 * steps);
  CHECK(right > 0.95 * steps);
}

TEST_CASE("two stored passes along a street share the probability of the third") {
  RandomStream random(7);
  const std::vector<EdgeValues> street = randomPath(150, random);
  Drive drive({});
  drive.lookAndStore(street);
  drive.beginPass();
  std::vector<EdgeValues> second;
  for (const EdgeValues& view : street) second.push_back(withNoise(view, kNoise, random));
  drive.lookAndStore(second);
  drive.beginPass();
  int found = 0;
  for (std::size_t i = 0; i < street.size(); ++i) {
    const auto places = drive.look(withNoise(street[i], kNoise, random));
    if (i < 12 || places.empty()) continue;
    double together = 0;
    for (const PlaceCandidate& place : places) {
      const std::int64_t away = place.view % 150 - static_cast<std::int64_t>(i);
      if (std::abs(away) <= 1) together += place.probability;
    }
    found += together > 0.8 ? 1 : 0;
  }
  CHECK(found > 0.9 * 138);
}

TEST_CASE("a path's cost goes on where a path came back to a known one") {
  for (const bool joined : {true, false}) {
    RandomStream random(8);
    const std::vector<EdgeValues> street = randomPath(100, random);
    const std::vector<EdgeValues> lane = randomPath(40, random);
    Drive drive({});
    drive.lookAndStore(street);
    drive.beginPass();
    drive.lookAndStore(lane);
    if (joined) drive.search().join(139, 50);  // the lane ended at view 50 of the street
    drive.beginPass();
    for (const EdgeValues& view : lane) drive.look(withNoise(view, kNoise, random));
    const auto places = drive.look(withNoise(street[50], kNoise, random));
    REQUIRE_FALSE(places.empty());
    CHECK((places.front().view == 50) == joined);
  }
}

TEST_CASE("a loaded search finds what the saved one finds, to the bit") {
  for (const std::int64_t exhaustive : {0, 4000}) {
    RandomStream random(9);
    SearchSettings settings;
    settings.exhaustive = exhaustive;
    const std::vector<EdgeValues> street = randomPath(170, random);
    Drive saved(settings);
    saved.lookAndStore(street);
    saved.beginPass();
    for (std::size_t i = 30; i < 50; ++i) saved.look(street[i]);
    Drive loaded = saved;  // the same mean and path
    loaded.search() = PlaceSearch(settings);
    StateReader reader = readerOf(bytesOf(saved.search()));
    REQUIRE(loaded.search().load(reader));
    REQUIRE(reader.complete());
    for (std::size_t i = 50; i < 90; ++i) {
      const EdgeValues view = withNoise(street[i], kNoise, random);
      const auto a = saved.look(view);
      const auto b = loaded.look(view);
      REQUIRE(a.size() == b.size());
      for (std::size_t k = 0; k < a.size(); ++k) {
        CHECK(a[k].view == b[k].view);
        CHECK(a[k].probability == b[k].probability);
      }
      if (i % 3 == 0) {
        saved.store(view);
        loaded.store(view);
      }
    }
    CHECK(bytesOf(saved.search()) == bytesOf(loaded.search()));
  }
}

TEST_CASE("damaged searches are refused") {
  RandomStream random(10);
  Drive drive({});
  drive.lookAndStore(randomPath(20, random));
  const std::string sound = bytesOf(drive.search());
  for (std::size_t length = 0; length < sound.size(); length += 53) {
    PlaceSearch search{SearchSettings()};
    StateReader reader = readerOf(sound.substr(0, length));
    const bool taken = search.load(reader) && reader.complete();
    CHECK_FALSE(taken);
  }
}
