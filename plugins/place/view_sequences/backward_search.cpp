// SPDX-License-Identifier: BSD-3-Clause
#include "backward_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "place_probability.hpp"
#include "usual_distance.hpp"

namespace tolman::view_sequences {
namespace {

// A grid contains the points that were seen on the last 30 m of path (street_points.hpp), so grids
// with less path between them share measurements. The rest is a margin. Chosen, not tuned.
constexpr double kSharedPath = 40;  // m
// Fewest compared grids from which the usual distance is estimated. Chosen, not tuned.
constexpr std::int64_t kMinGrids = 10;
// z of a view that is not compared: large enough for a cost above 0, which counts as 0.
constexpr float kNotCompared = 5;

SearchSettings backwards(SearchSettings settings) {
  settings.recent = std::max(settings.recent, kSharedPath);
  settings.cost.direction = Direction::Backwards;
  settings.cost.penalty = 1;
  return settings;
}

}  // namespace

BackwardSearch::BackwardSearch(const SearchSettings& settings)
    : settings_(backwards(settings)), cost_(settings_.cost) {}

bool BackwardSearch::hasOwnGrid(std::int64_t view) const {
  const auto i = static_cast<std::size_t>(view);
  return grid_of_view_[i] >= 0 && (view == 0 || grid_of_view_[i - 1] != grid_of_view_[i]);
}

void BackwardSearch::add(const std::optional<StructureLevels>& levels, double path,
                         std::int64_t predecessor) {
  const std::int64_t view = size();
  std::int32_t grid = -1;
  if (levels) {
    const bool shares = predecessor >= 0 && predecessor == view - 1 && hasOwnGrid(predecessor);
    grid = shares ? grid_of_view_.back() : static_cast<std::int32_t>(grids());
    if (!shares) cells_.insert(cells_.end(), levels->begin(), levels->end());
  }
  grid_of_view_.push_back(grid);
  paths_.push_back(static_cast<float>(path));
  cost_.add(predecessor);
}

void BackwardSearch::beginPass() {
  cost_.forget();
  candidates_ = 0;
}

std::span<const std::uint8_t, kCells> BackwardSearch::grid(std::int64_t index) const {
  return std::span<const std::uint8_t, kCells>(cells_.data() + index * kCells, kCells);
}

StructureLevels BackwardSearch::levelsOf(std::int64_t view) const {
  StructureLevels levels;
  std::ranges::copy(grid(grid_of_view_[static_cast<std::size_t>(view)]), levels.begin());
  return levels;
}

void BackwardSearch::step(const StructureQuery* query, double path, double advance) {
  candidates_ = 0;
  if (query == nullptr) {
    cost_.forget();
    return;
  }
  std::int64_t views = size();
  while (views > 0 && paths_[static_cast<std::size_t>(views) - 1] > path - settings_.recent)
    --views;
  candidates_ = views;
  compareAll(*query);
  cost_.step(distances_, advance, candidates_);
}

/// Computes the standardised distances of all views. Only the newest `exhaustive` grids are
/// compared.
void BackwardSearch::compareAll(const StructureQuery& query) {
  std::int64_t end = 0;  // number of grids of candidates, which are the first ones
  for (std::int64_t view = candidates_; view > 0 && end == 0; --view) {
    end = grid_of_view_[static_cast<std::size_t>(view) - 1] + 1;
  }
  const std::int64_t first = std::max<std::int64_t>(0, end - settings_.exhaustive);
  of_grids_.resize(static_cast<std::size_t>(end - first));
  for (std::int64_t i = first; i < end; ++i) {
    of_grids_[static_cast<std::size_t>(i - first)] = query.distanceTo(grid(i));
  }
  const UsualDistance usual(sumsOf(of_grids_));
  distances_.assign(paths_.size(), kNotCompared);
  if (end - first < kMinGrids) return;
  for (std::int64_t view = 0; view < candidates_; ++view) {
    const std::int64_t i = grid_of_view_[static_cast<std::size_t>(view)];
    if (i < first) continue;
    distances_[static_cast<std::size_t>(view)] =
        usual.standardised(of_grids_[static_cast<std::size_t>(i - first)]);
  }
}

/// Whether one of the next views has no structure. The cost would then remain at this view
/// while the robot drives on.
bool BackwardSearch::isAtEnd(std::int64_t view) const {
  constexpr std::int64_t kAhead = 5;  // views; chosen, not tuned
  if (view < kAhead) return true;
  const auto* grids = grid_of_view_.data() + view;
  return std::any_of(grids - kAhead, grids + 1, [](std::int32_t grid) { return grid < 0; });
}

std::optional<PlaceCandidate> BackwardSearch::best() const {
  const auto cost = cost_.cost().first(static_cast<std::size_t>(candidates_));
  if (cost.empty()) return {};
  const std::int64_t best = std::ranges::min_element(cost) - cost.begin();
  const float own = cost[static_cast<std::size_t>(best)];
  if (!(own < 0) || isAtEnd(best)) return {};
  float other = 0;
  for (std::int64_t i = 0; i < candidates_; ++i) {
    if (std::abs(i - best) > kSamePlace) other = std::min(other, cost[static_cast<std::size_t>(i)]);
  }
  return PlaceCandidate{best, probabilityOf(own, {other, kCostOfNovelty})};
}

void BackwardSearch::save(StateWriter& writer) const {
  writer.put(static_cast<std::uint64_t>(grids()));
  writer.putAll<std::uint8_t>(cells_);
  writer.putAll<std::int32_t>(grid_of_view_);
  writer.putAll<float>(paths_);
  cost_.save(writer);
}

bool BackwardSearch::load(StateReader& reader, std::int64_t views) {
  *this = BackwardSearch(settings_);
  const auto count = reader.get<std::uint64_t>();
  const auto each = sizeof(std::int32_t) + sizeof(float);
  if (count > reader.remaining() / kCells) return false;
  if (static_cast<std::uint64_t>(views) > reader.remaining() / each) return false;
  cells_.resize(count * kCells);
  reader.getAll<std::uint8_t>(cells_);
  grid_of_view_.resize(static_cast<std::size_t>(views));
  reader.getAll<std::int32_t>(grid_of_view_);
  paths_.resize(static_cast<std::size_t>(views));
  reader.getAll<float>(paths_);
  std::int32_t last = -1;
  for (const std::int32_t grid : grid_of_view_) {
    if (grid != -1 && grid != last && grid != last + 1) return false;
    last = std::max(last, grid);
  }
  const bool sound = last + 1 == grids() &&
                     std::ranges::all_of(cells_, [](std::uint8_t level) { return level <= 15; }) &&
                     std::ranges::all_of(paths_, [](float path) { return std::isfinite(path); });
  return sound && cost_.load(reader, views);
}

}  // namespace tolman::view_sequences
