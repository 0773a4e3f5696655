// SPDX-License-Identifier: BSD-3-Clause
// The matcher against a brute-force search in floating point.
#include "matcher.hpp"

#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::view_templates;

namespace {

constexpr int kColumns = 30;
constexpr int kRows = 6;

LocalView randomView(RandomStream& random) {
  LocalView view;
  for (int i = 0; i < kColumns * kRows; ++i) {
    view.cells.push_back(static_cast<float>(random.uniform()));
    view.mean += view.cells.back() / static_cast<double>(kColumns * kRows);
  }
  return view;
}

/// The view as it looks when the scene has moved `cells` to the right; the edge is repeated.
LocalView moved(const LocalView& view, int cells) {
  LocalView result = view;
  for (int r = 0; r < kRows; ++r) {
    for (int c = 0; c < kColumns; ++c) {
      const int from = std::clamp(c - cells, 0, kColumns - 1);
      result.cells[static_cast<std::size_t>(r * kColumns + c)] =
          view.cells[static_cast<std::size_t>(r * kColumns + from)];
    }
  }
  return result;
}

float at(const LocalView& view, int row, int column) {
  return view.cells[static_cast<std::size_t>(row * kColumns + column)];
}

/// Mean absolute difference at one offset, straight from the description.
double naiveDistance(const LocalView& now, const LocalView& stored, int offset,
                     const MatchSettings& s) {
  const int first = s.panoramic ? 0 : s.shift;
  const int last = s.panoramic ? kColumns : kColumns - s.shift;
  double sum = 0;
  for (int r = 0; r < kRows; ++r) {
    for (int c = first; c < last; ++c) {
      const int other = s.panoramic ? (c + offset) % kColumns : c - s.shift + offset;
      sum += std::abs(at(now, r, c) - at(stored, r, other));
    }
  }
  return sum / (kRows * (last - first));
}

TemplateMatch naiveNearest(const LocalView& now, const std::vector<LocalView>& stored,
                           const MatchSettings& s) {
  TemplateMatch best;
  best.distance = 1e9;
  for (std::size_t id = 0; id < stored.size(); ++id) {
    if (std::abs(now.mean - stored[id].mean) > s.threshold + 0.005) continue;
    for (int offset = 0; offset <= (s.panoramic ? kColumns - 1 : 2 * s.shift); offset += s.step) {
      const double distance = naiveDistance(now, stored[id], offset, s);
      if (distance < best.distance) best = {static_cast<std::int64_t>(id), distance, 0};
    }
  }
  return best;
}

TemplateBank bankOf(const std::vector<LocalView>& views) {
  TemplateBank bank(kColumns, kRows);
  for (const LocalView& view : views) bank.add(view);
  return bank;
}

}  // namespace

TEST_CASE("the nearest template is the brute-force one") {
  RandomStream random(11);
  std::vector<LocalView> stored;
  for (int i = 0; i < 40; ++i) stored.push_back(randomView(random));
  const TemplateBank bank = bankOf(stored);
  const auto settings =
      GENERATE(MatchSettings{4, 1, 0.02}, MatchSettings{5, 2, 0.5}, MatchSettings{0, 1, 0.5},
               MatchSettings{0, 1, 0.5, true}, MatchSettings{0, 5, 0.01, true});
  Matcher matcher(settings, kColumns, kRows);
  for (int i = 0; i < 30; ++i) {
    LocalView now = randomView(random);
    if (i % 3 == 0) now = moved(stored[static_cast<std::size_t>(i)], i % 4 - 2);
    const TemplateMatch expected = naiveNearest(now, stored, settings);
    const TemplateMatch match = matcher.nearest(now, bank);
    CHECK(match.id == expected.id);
    if (match.id < 0) continue;
    CHECK(match.distance == Approx(expected.distance).margin(1.0 / kOne));  // fixed point
  }
}

TEST_CASE("whole shifts are recovered with their sign") {
  RandomStream random(12);
  const std::vector<LocalView> stored = {randomView(random), randomView(random),
                                         randomView(random)};
  const TemplateBank bank = bankOf(stored);
  Matcher matcher({4, 1, 0.5}, kColumns, kRows);
  for (int cells = -4; cells <= 4; ++cells) {
    const TemplateMatch match = matcher.nearest(moved(stored[1], cells), bank);
    CHECK(match.id == 1);
    CHECK(match.distance == 0);
    CHECK(match.moved_right == Approx(cells).margin(0.2));
  }
}

TEST_CASE("a template with another mean is not looked at") {
  LocalView dark;
  dark.cells.assign(kColumns * kRows, 0.2F);
  dark.mean = 0.2;
  LocalView light;
  light.cells.assign(kColumns * kRows, 0.3F);
  light.mean = 0.3;
  const TemplateBank bank = bankOf({dark});
  CHECK(Matcher({4, 1, 0.094}, kColumns, kRows).nearest(light, bank).id == -1);  // 0.1 > 0.099
  const TemplateMatch match = Matcher({4, 1, 0.096}, kColumns, kRows).nearest(light, bank);
  CHECK(match.id == 0);
  CHECK(match.distance == Approx(0.1).margin(1e-4));
}

TEST_CASE("equal templates: the older one wins") {
  RandomStream random(13);
  const LocalView view = randomView(random);
  const TemplateBank bank = bankOf({view, view, view});
  CHECK(Matcher({4, 1, 0.5}, kColumns, kRows).nearest(view, bank).id == 0);
}

TEST_CASE("an empty bank has no nearest template") {
  RandomStream random(14);
  const TemplateMatch match =
      Matcher({4, 1, 0.5}, kColumns, kRows).nearest(randomView(random), bankOf({}));
  CHECK(match.id == -1);
  CHECK(match.distance == 1);
}

TEST_CASE("vertical shifts are tried in every layer, and never across layers") {
  // Two layers of 3 rows: the later view is the earlier one, a row higher in both.
  constexpr int kLayers = 2;
  RandomStream random(15);
  const LocalView stored = randomView(random);
  LocalView now = stored;
  for (int layer = 0; layer < kLayers; ++layer) {
    const int top = layer * kRows / kLayers;
    for (int r = 0; r + 1 < kRows / kLayers; ++r) {
      const auto from = stored.cells.begin() + (top + r + 1) * kColumns;
      std::copy(from, from + kColumns, now.cells.begin() + (top + r) * kColumns);
    }
  }
  const TemplateBank bank = bankOf({randomView(random), stored});
  const MatchSettings still = {2, 1, 0.9, false, 0, kLayers};
  const MatchSettings nodding = {2, 1, 0.9, false, 1, kLayers};
  const TemplateMatch match = Matcher(nodding, kColumns, kRows / kLayers).nearest(now, bank);
  CHECK(match.id == 1);
  CHECK(match.distance == 0);
  CHECK(match.moved_right == Approx(0).margin(0.2));
  CHECK(Matcher(still, kColumns, kRows / kLayers).nearest(now, bank).distance > 0.1);
  CHECK_THROWS_AS(Matcher({2, 1, 0.9, false, 2, kLayers}, kColumns, kRows / kLayers),
                  std::invalid_argument);
}
