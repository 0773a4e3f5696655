// SPDX-License-Identifier: BSD-3-Clause
#include "view_bank.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "wide_lanes.hpp"

namespace tolman::view_sequences {

namespace {

// Views of a chunk. Its mean is that of three chunks, with its neighbours. On campus walks
// (places_gardens) means over 80 to 400 views were equally good, over 40 worse.
constexpr std::int64_t kChunkViews = 64;
constexpr std::int64_t kMaxPasses = std::int64_t{1} << 40;  // a larger number is damage

using Levels = std::array<std::int16_t, kValues>;

Levels levelsOf(std::span<const std::uint8_t> view) {
  Levels levels;
  unpack(view, levels);
  return levels;
}

}  // namespace

void ViewBank::add(const PackedView& view, double path) {
  views_.insert(views_.end(), view.begin(), view.end());
  paths_.push_back(static_cast<float>(path));
  deviations_.push_back(0);
  if (chunks_.empty() || chunks_.back().pass != pass_ || chunks_.back().count == kChunkViews) {
    chunks_.push_back({size() - 1, 0, pass_, {}});
  }
  ++chunks_.back().count;
  const std::size_t last = chunks_.size() - 1;
  if (last > 0) refresh(last - 1);
  refresh(last);
}

/// Computes the mean of a chunk and its neighbours of the same pass, and the deviations from it.
void ViewBank::refresh(std::size_t index) {
  Chunk& chunk = chunks_[index];
  std::array<std::int32_t, kValues> sums{};
  std::int64_t count = 0;
  const std::size_t last = std::min(index + 1, chunks_.size() - 1);
  for (std::size_t c = index == 0 ? 0 : index - 1; c <= last; ++c) {
    const Chunk& near = chunks_[c];
    if (near.pass != chunk.pass) continue;
    for (std::int64_t i = near.first; i < near.first + near.count; ++i) {
      const Levels levels = levelsOf(view(i));
      for (std::size_t k = 0; k < kValues; ++k) sums[k] += levels[k];
    }
    count += near.count;
  }
  for (std::size_t k = 0; k < kValues; ++k) {
    const float mean = static_cast<float>(sums[k]) / static_cast<float>(count);
    chunk.mean[k] = static_cast<std::uint8_t>(std::lround(mean * kMeanScale));
  }
  for (std::int64_t i = chunk.first; i < chunk.first + chunk.count; ++i) {
    const Levels levels = levelsOf(view(i));
    std::int64_t squares = 0;  // in units of 1 / kMeanScale^2
    for (std::size_t k = 0; k < kValues; ++k) {
      const int away = levels[k] * static_cast<int>(kMeanScale) - chunk.mean[k];
      squares += away * away;
    }
    deviations_[static_cast<std::size_t>(i)] = std::sqrt(static_cast<float>(squares)) / kMeanScale;
  }
}

bool ViewBank::isSettled(std::size_t c) const {
  if (c + 1 >= chunks_.size()) return chunks_[c].pass != pass_;
  const Chunk& next = chunks_[c + 1];
  return next.pass != chunks_[c].pass || next.pass != pass_ || next.count == kChunkViews;
}

void ViewBank::save(StateWriter& writer) const {
  writer.put(size());
  writer.putAll<std::uint8_t>(views_);
  writer.putAll<float>(paths_);
  writer.put(static_cast<std::uint64_t>(chunks_.size()));
  for (const Chunk& chunk : chunks_) {
    writer.put(chunk.count);
    writer.put(chunk.pass);
  }
  writer.put(pass_);
}

bool ViewBank::load(StateReader& reader) {
  *this = ViewBank();
  const auto count = reader.get<std::uint64_t>();
  if (count > reader.remaining() / (kPackedBytes + sizeof(float))) return false;
  views_.resize(count * kPackedBytes);
  paths_.resize(count);
  deviations_.resize(count);
  reader.getAll<std::uint8_t>(views_);
  reader.getAll<float>(paths_);
  const auto chunks = reader.get<std::uint64_t>();
  std::int64_t first = 0;
  for (std::uint64_t c = 0; c < chunks && reader.remaining() > 0; ++c) {
    Chunk chunk;
    chunk.first = first;
    chunk.count = reader.get<std::int64_t>();
    chunk.pass = reader.get<std::int64_t>();
    const std::int64_t before = chunks_.empty() ? 0 : chunks_.back().pass;
    if (chunk.count < 1 || chunk.count > kChunkViews || chunk.pass < before) return false;
    first += chunk.count;
    chunks_.push_back(chunk);
  }
  pass_ = reader.get<std::int64_t>();
  const bool sound = pass_ >= (chunks_.empty() ? 0 : chunks_.back().pass) && pass_ < kMaxPasses &&
                     std::ranges::all_of(paths_, [](float path) { return std::isfinite(path); });
  if (!sound || first != size()) return false;
  for (std::size_t c = 0; c < chunks_.size(); ++c) refresh(c);
  return true;
}

namespace {

// Deviations are within 15 levels: products of 624 values with levels fit 32 bits.
constexpr float kFixedScale = 64;

/// The overlap of the view and a stored view at one shift, as indices of values.
struct Overlap {
  int view;
  int stored;
  int count;
};

Overlap overlapAt(int index) {
  const int shift = index - kShift;
  return {std::max(0, -shift) * kColumnValues, std::max(0, shift) * kColumnValues,
          (kColumns - std::abs(shift)) * kColumnValues};
}

/// In integers, so that the order of summation does not matter.
TOLMAN_WIDE_LANES std::int32_t innerProduct(const std::int16_t* a, const std::int16_t* b,
                                            int count) {
  std::int32_t sum = 0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

ViewQuery::ViewQuery(const EdgeValues& view, const EdgeValues& mean_of_pass) {
  for (std::size_t i = 0; i < kValues; ++i) {
    deviation_[i] = std::clamp(view[i] - mean_of_pass[i], -15.0F, 15.0F);
    fixed_[i] = static_cast<std::int16_t>(std::lround(deviation_[i] * kFixedScale));
  }
  for (int s = 0; s < kShifts; ++s) {
    const Overlap part = overlapAt(s);
    const std::int16_t* values = fixed_.data() + part.view;
    const double squares =
        innerProduct(values, values, part.count) / static_cast<double>(kFixedScale * kFixedScale);
    // The stored norm is that of all columns; it is scaled to the share of the overlap.
    const double share = std::sqrt(static_cast<double>(kValues) / part.count);
    scales_[static_cast<std::size_t>(s)] =
        squares > 0 ? static_cast<float>(share / std::sqrt(squares)) : 0;
  }
}

ViewQuery::ChunkProducts ViewQuery::productsWith(const Chunk& chunk) const {
  std::array<std::int16_t, kValues> mean;
  std::copy(chunk.mean.begin(), chunk.mean.end(), mean.begin());
  ChunkProducts products;
  for (int s = 0; s < kShifts; ++s) {
    const Overlap part = overlapAt(s);
    products[static_cast<std::size_t>(s)] =
        static_cast<float>(
            innerProduct(fixed_.data() + part.view, mean.data() + part.stored, part.count)) /
        (kFixedScale * kMeanScale);
  }
  return products;
}

std::array<float, kShifts> ViewQuery::distances(std::span<const std::int16_t, kValues> levels,
                                                const ChunkProducts& of_chunk,
                                                float deviation) const {
  std::array<float, kShifts> distances;
  for (int s = 0; s < kShifts; ++s) {
    const auto i = static_cast<std::size_t>(s);
    const Overlap part = overlapAt(s);
    const float product = static_cast<float>(innerProduct(
                              fixed_.data() + part.view, levels.data() + part.stored, part.count)) /
                          kFixedScale;
    distances[i] = deviation > 0 ? 1 - (product - of_chunk[i]) * scales_[i] / deviation : 1;
  }
  return distances;
}

ViewDistance ViewQuery::distanceTo(std::span<const std::int16_t, kValues> levels,
                                   const ChunkProducts& of_chunk, float deviation) const {
  const auto all = distances(levels, of_chunk, deviation);
  const auto best = std::ranges::min_element(all);
  return {*best, static_cast<int>(best - all.begin()) - kShift};
}

}  // namespace tolman::view_sequences
