// SPDX-License-Identifier: BSD-3-Clause
#include "backward_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "path_cost.hpp"

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

namespace {

// Turns of the structure that are tried: streets are driven nearly along their direction. Their
// number and the step below are chosen, not tuned.
constexpr std::size_t kYaws = 5;

double yawOf(double index) { return 0.08 * (index - (kYaws - 1) / 2.0); }  // rad

// Least probability of a place whose pose is measured. It is below that of an answer, because an
// answer must agree with an earlier measurement. Chosen, not tuned.
constexpr double kMeasuredFrom = 0.5;
// Least correlation of the structure of the same street: 97 of 100 right places reach it.
// Chosen on district (docs/report/places.md).
constexpr double kMinCorrelation = 0.28;
// Correction along the street: a camera sees only the near sides of objects, so structure of the
// opposite direction fits best about a metre too far back. Measured on district (1.0 m), checked on
// a route of another town (0.8 m).
constexpr double kNearSides = 1.0;  // m
// Standard deviations of the measured pose. Those to the side and of the yaw were measured on
// district. That along the street is larger, because the thickness of objects differs.
constexpr double kSigmaSide = 0.4;    // m
constexpr double kSigmaHeight = 0.5;  // m; not measured
constexpr double kSigmaAlong = 1.2;   // m
constexpr double kSigmaTilt = 0.05;   // rad; not measured
constexpr double kSigmaYaw = 0.06;    // rad

Matrix6d covarianceOfStructure() {
  Vector6d sigma;
  sigma << kSigmaSide, kSigmaHeight, kSigmaAlong, kSigmaTilt, kSigmaYaw, kSigmaTilt;
  return sigma.cwiseAbs2().asDiagonal();
}

}  // namespace

void BackwardPlaces::move(const Motion& motion) {
  if (!canMeasure()) return;
  if (!motion.scale_known) street_.restart();  // points at unknown distances cannot be joined
  street_.move(motion.T_previous_current);
}

void BackwardPlaces::step(const PathStep& step, const Frame& frame) {
  if (!canMeasure()) return;
  if (step.begins_pass) {
    street_.restart();
    search_.beginPass();
    agreement_.forget();
  }
  path_ = step.path;
  if (street_.wantsPoints(step.path)) street_.add(stereo_.pointsOf(frame), step.path);
  current_ = street_.levels();
  if (!current_) return search_.step(nullptr, step.path, step.advance);
  mean_.add(*current_);
  const StructureQuery query(*current_, mean_);
  search_.step(&query, step.path, step.advance);
}

void BackwardPlaces::add(double path, std::int64_t predecessor) {
  if (!canMeasure()) return;
  search_.add(current_, path, predecessor);
  const PlanarPose pose = toPlanar(street_.pose());
  for (const double value : {pose.x, pose.y, pose.theta})
    poses_.push_back(static_cast<float>(value));
}

void BackwardPlaces::join(std::int64_t from, std::int64_t to) {
  if (canMeasure()) search_.join(from, to);
}

std::optional<BackwardPlace> BackwardPlaces::find(double probability) {
  if (!canMeasure() || !current_) return {};
  const std::optional<PlaceCandidate> candidate = search_.best();
  if (!candidate || candidate->probability < std::min(probability, kMeasuredFrom)) return {};
  const std::optional<BackwardPlace> place = located(*candidate);
  if (!place) return {};
  const float* stored = poses_.data() + 3 * place->view;
  const PlanarPose on_path =
      compose({stored[0], stored[1], stored[2]}, toPlanar(place->T_template_current));
  const bool agrees = agreement_.add(path_, on_path, toPlanar(street_.pose()));
  return agrees && candidate->probability >= probability ? place : std::nullopt;
}

/// The fit at the turn at which the structures agree best.
BackwardPlaces::TurnedFit BackwardPlaces::bestFit(const StructureDeviation& stored) const {
  std::array<StructureFit, kYaws> fits;
  std::size_t at = 0;
  for (std::size_t i = 0; i < kYaws; ++i) {
    const auto levels = street_.levels(yawOf(static_cast<double>(i)));
    if (levels) fits[i] = fitStructure(turned(mean_.deviationOf(*levels)), stored);
    if (fits[i].correlation > fits[at].correlation) at = i;
  }
  if (at == 0 || at + 1 == kYaws) return {};
  const double between =
      peakOf(fits[at - 1].correlation, fits[at].correlation, fits[at + 1].correlation);
  return {fits[at], yawOf(static_cast<double>(at) + between)};
}

/// The measured pose at a candidate. Empty if the structures do not agree, or agree better for the
/// same driving direction.
std::optional<BackwardPlace> BackwardPlaces::located(const PlaceCandidate& candidate) const {
  const StructureDeviation stored = mean_.deviationOf(search_.levelsOf(candidate.view));
  const TurnedFit best = bestFit(stored);
  if (!best.fit.within || best.fit.correlation < kMinCorrelation) return {};
  const StructureFit same = fitStructure(mean_.deviationOf(*current_), stored);
  if (same.correlation > best.fit.correlation) return {};
  BackwardPlace place{candidate.view, candidate.probability, {}, covarianceOfStructure()};
  place.T_template_current.setIdentity();
  place.T_template_current.translation() << best.fit.lateral, 0, best.fit.ahead + kNearSides;
  place.T_template_current.linear() = expSo3({0, std::numbers::pi - best.yaw, 0});
  return place;
}

void BackwardPlaces::save(StateWriter& writer) const {
  writer.put(static_cast<std::uint8_t>(current_.has_value()));
  if (current_) writer.putAll<std::uint8_t>(*current_);
  street_.save(writer);
  mean_.save(writer);
  writer.put(path_);
  writer.putAll<float>(poses_);
  agreement_.save(writer);
  if (canMeasure()) search_.save(writer);
}

bool BackwardPlaces::load(StateReader& reader, std::int64_t views) {
  current_.reset();
  if (reader.get<std::uint8_t>() != 0) reader.getAll<std::uint8_t>(current_.emplace());
  if (!street_.load(reader) || !mean_.load(reader)) return false;
  path_ = reader.get<double>();
  const auto values = canMeasure() ? static_cast<std::uint64_t>(3 * views) : 0;
  if (values > reader.remaining() / sizeof(float)) return false;
  poses_.resize(values);
  reader.getAll<float>(poses_);
  const bool sound = std::isfinite(path_) &&
                     std::ranges::all_of(poses_, [](float value) { return std::isfinite(value); });
  return sound && agreement_.load(reader) && (!canMeasure() || search_.load(reader, views));
}

}  // namespace tolman::view_sequences
