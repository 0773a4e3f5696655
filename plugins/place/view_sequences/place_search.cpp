// SPDX-License-Identifier: BSD-3-Clause
#include "place_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "path_cost.hpp"
#include "wide_lanes.hpp"

namespace tolman::view_sequences {
namespace {

// Fewest compared views from which the usual distance is estimated. Chosen, not tuned.
constexpr std::int64_t kMinCompared = 4;
// Number of the best views by codes that are then compared in full, and size of the sample of views
// for the usual distance. Chosen, not tuned; they bound the time.
constexpr std::size_t kShortList = 50;
constexpr std::int64_t kSample = 256;
// The views of one place span about 2 * kSamePlace indices, so this many best views contain the
// requested places and one more, with which the best is compared.
constexpr std::size_t kBestViews = (PlaceSearch::kMaxPlaces + 1) * 2 * kSamePlace;

/// 1 - cosine of the angle that corresponds to this number of differing bits.
float distanceOfBits(int bits) {
  return static_cast<float>(1 - std::cos(std::numbers::pi * bits / kCodeBits));
}

/// The smallest of the values and 0.
TOLMAN_WIDE_LANES float leastOf(const float* values, std::int64_t count) {
  float lanes[8] = {};
  std::int64_t i = 0;
  for (; i + 8 <= count; i += 8) {
    for (int k = 0; k < 8; ++k) lanes[k] = values[i + k] < lanes[k] ? values[i + k] : lanes[k];
  }
  float least = 0;
  for (const float lane : lanes) least = std::min(least, lane);
  for (; i < count; ++i) least = std::min(least, values[i]);
  return least;
}

TOLMAN_WIDE_LANES void lookUp(const float* table, const std::uint16_t* at, float* values,
                              std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) values[i] = table[at[i]];
}

}  // namespace

void PlaceSearch::add(const PackedView& view, double path, std::int64_t predecessor) {
  bank_.add(view, path);
  cost_.add(predecessor);
  codes_.update(bank_);
}

void PlaceSearch::beginPass() {
  bank_.beginPass();
  codes_.update(bank_);
  cost_.forget();
  best_.clear();
}

std::int64_t PlaceSearch::coded() const {
  return bank_.size() > settings_.exhaustive ? codes_.size() : 0;
}

void PlaceSearch::step(const ViewQuery& query, double path, double advance) {
  candidates_ = 0;
  best_.clear();
  if (bank_.size() == 0) return;
  candidates_ = viewsUntil(path - settings_.recent);
  compareAll(query);
  cost_.step(distances_, advance, candidates_);
  if (coded() > 0) {
    refineBest(query);
  } else {
    best_ = bestViews(kBestViews);
  }
  cost_of_recent_ = 0;
  const std::int64_t end = viewsUntil(path - 0.5 * settings_.recent);
  for (std::int64_t i = candidates_; i < end; ++i) {
    cost_of_recent_ = std::min(cost_of_recent_, costOf(i));
  }
}

/// Number of stored views up to `path`, in m of driven path.
std::int64_t PlaceSearch::viewsUntil(double path) const {
  std::int64_t views = bank_.size();
  while (views > 0 && bank_.path(views - 1) > path) --views;
  return views;
}

/// Computes the standardised distances of all stored views: by code for views that have one, the
/// others in full.
void PlaceSearch::compareAll(const ViewQuery& query) {
  const std::int64_t views = bank_.size();
  const std::int64_t by_code = coded();
  const std::int64_t compared = std::min(views, std::max(candidates_, kMinCompared));
  distances_.resize(static_cast<std::size_t>(views));
  if (by_code > 0) codes_.distances(query, bits_);
  compareFrom(query, by_code);
  const std::span<float> in_full = std::span(distances_).subspan(static_cast<std::size_t>(by_code));
  Sums sums = sumsOf(
      in_full.first(static_cast<std::size_t>(std::max<std::int64_t>(compared - by_code, 0))));
  if (by_code > 0) sums.add(sumsOfBits(std::min(compared, by_code)));
  const UsualDistance usual(sums);
  for (float& distance : in_full) distance = usual.standardised(distance);
  if (by_code == 0) return;
  std::array<float, kCodeBits + 1> z_of_bits;
  for (int b = 0; b <= kCodeBits; ++b) {
    z_of_bits[static_cast<std::size_t>(b)] = usual.standardised(distanceOfBits(b));
  }
  lookUp(z_of_bits.data(), bits_.data(), distances_.data(), by_code);
}

/// Sums of the distances, by codes, of the first `count` views, or of a sample of them.
Sums PlaceSearch::sumsOfBits(std::int64_t count) const {
  constexpr std::int64_t kEnough = 65536;  // views; bounds the time; chosen, not tuned
  const std::int64_t stride = 1 + count / kEnough;
  std::array<std::int64_t, kCodeBits + 1> views_with{};
  for (std::int64_t i = 0; i < count; i += stride) ++views_with[bits_[static_cast<std::size_t>(i)]];
  Sums sums;
  for (int b = 0; b <= kCodeBits; ++b) {
    const auto views =
        static_cast<double>(views_with[static_cast<std::size_t>(b)]) * static_cast<double>(stride);
    sums.add({views, views * distanceOfBits(b), views * distanceOfBits(b) * distanceOfBits(b)});
  }
  return sums;
}

void PlaceSearch::compareFrom(const ViewQuery& query, std::int64_t first) {
  std::array<std::int16_t, kValues> levels;
  const std::vector<Chunk>& chunks = bank_.chunks();
  auto begin = std::ranges::upper_bound(chunks, first, {}, &Chunk::first);
  if (begin != chunks.begin()) --begin;
  for (const Chunk& chunk : std::span(begin, chunks.end())) {
    const std::int64_t end = chunk.first + chunk.count;
    const ViewQuery::ChunkProducts products = query.productsWith(chunk);
    for (std::int64_t i = std::max(first, chunk.first); i < end; ++i) {
      unpack(bank_.view(i), levels);
      distances_[static_cast<std::size_t>(i)] =
          query.distanceTo(levels, products, bank_.deviation(i)).distance;
    }
  }
}

std::vector<float> PlaceSearch::distancesOf(const ViewQuery& query,
                                            const std::vector<std::int64_t>& views) {
  std::vector<float> distances;
  distances.reserve(views.size());
  for (const std::int64_t view : views) {
    distances.push_back(static_cast<float>(shiftOf(query, bank_, view).distance));
  }
  return distances;
}

/// Corrects the costs of the best views by full comparisons instead of codes.
void PlaceSearch::refineBest(const ViewQuery& query) {
  std::vector<std::int64_t> sample;
  for (std::int64_t k = 0; k < kSample; ++k) sample.push_back(k * candidates_ / kSample);
  const UsualDistance usual(sumsOf(distancesOf(query, sample)));
  // The order of the other views does not change, so the best views are among these.
  best_ = bestViews(kBestViews + kShortList);
  std::vector<std::int64_t> corrected = best_;
  corrected.resize(std::min(corrected.size(), kShortList));
  std::erase_if(corrected, [&](std::int64_t view) { return view >= coded(); });
  const std::vector<float> distances = distancesOf(query, corrected);
  for (std::size_t i = 0; i < corrected.size(); ++i) {
    const float by_code = distances_[static_cast<std::size_t>(corrected[i])];
    cost_.correct(corrected[i], usual.standardised(distances[i]) - by_code);
  }
  std::erase_if(best_, [&](std::int64_t view) { return costOf(view) >= 0; });
  std::ranges::sort(best_, {}, [&](std::int64_t view) { return std::pair(costOf(view), view); });
  best_.resize(std::min(best_.size(), kBestViews));
}

/// The candidates with the lowest cost, best first; of equal ones the older.
std::vector<std::int64_t> PlaceSearch::bestViews(std::size_t count) const {
  const std::span<const float> cost = cost_.cost();
  std::vector<std::int64_t> best;
  const auto isBetter = [&](std::int64_t a, std::int64_t b) {
    return cost[static_cast<std::size_t>(a)] < cost[static_cast<std::size_t>(b)];
  };
  float limit = 0;                     // views with a cost of 0 and above are not places
  constexpr std::int64_t kBlock = 64;  // views; only for speed
  for (std::int64_t block = 0; block < candidates_; block += kBlock) {
    const std::int64_t end = std::min(block + kBlock, candidates_);
    if (leastOf(cost.data() + block, end - block) >= limit) continue;
    for (std::int64_t i = block; i < end; ++i) {
      if (cost[static_cast<std::size_t>(i)] >= limit) continue;
      best.insert(std::upper_bound(best.begin(), best.end(), i, isBetter), i);
      if (best.size() > count) best.pop_back();
      if (best.size() == count) limit = cost[static_cast<std::size_t>(best.back())];
    }
  }
  return best;
}

std::vector<PlaceCandidate> PlaceSearch::candidates(int most) const {
  std::vector<PlaceCandidate> found;
  if (candidates_ < kMinCompared) return found;
  std::vector<std::int64_t> places;  // the best view of each
  const auto count = static_cast<std::size_t>((most + 1) * 2 * kSamePlace);
  for (const std::int64_t view : std::span(best_).first(std::min(count, best_.size()))) {
    const bool known = std::ranges::any_of(
        places, [&](std::int64_t place) { return std::abs(place - view) <= kSamePlace; });
    if (!known) places.push_back(view);
  }
  const auto costOfPlace = [&](std::size_t i) {
    return i < places.size() ? static_cast<double>(costOf(places[i])) : 0.0;
  };
  for (std::size_t i = 0; i < places.size() && static_cast<int>(i) < most; ++i) {
    const double other = costOfPlace(i == 0 ? 1 : 0);
    found.push_back(
        {places[i], probabilityOf(costOfPlace(i), {other, cost_of_recent_, kCostOfNovelty})});
  }
  return found;
}

void PlaceSearch::save(StateWriter& writer) const {
  bank_.save(writer);
  cost_.save(writer);
}

bool PlaceSearch::load(StateReader& reader) {
  codes_ = PlaceCodes();
  best_.clear();
  if (!bank_.load(reader) || !cost_.load(reader, bank_.size())) return false;
  codes_.update(bank_);
  return true;
}

MeasuredShift shiftOf(const ViewQuery& query, const ViewBank& bank, std::int64_t view) {
  const auto chunk = std::prev(std::ranges::upper_bound(bank.chunks(), view, {}, &Chunk::first));
  std::array<std::int16_t, kValues> levels;
  unpack(bank.view(view), levels);
  const auto d = query.distances(levels, query.productsWith(*chunk), bank.deviation(view));
  const auto best = static_cast<std::size_t>(std::ranges::min_element(d) - d.begin());
  double between = 0;
  if (best > 0 && best + 1 < d.size()) {
    const double curvature = d[best - 1] - 2.0 * d[best] + d[best + 1];
    if (curvature > 0) between = 0.5 * (d[best - 1] - d[best + 1]) / curvature;
  }
  return {d[best], static_cast<double>(best) - kShift + between};
}

}  // namespace tolman::view_sequences
