// SPDX-License-Identifier: BSD-3-Clause
#include "profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>

namespace tolman::scanline {

namespace {

/// Adds the grey values, or the sums of the channels, of a part of one row to `sums`.
void addRow(const std::uint8_t* pixels, int channels, std::vector<std::uint32_t>& sums) {
  for (std::uint32_t& sum : sums) {
    for (int c = 0; c < channels; ++c) sum += *pixels++;
  }
}

int pixelsBefore(double fraction, int size) {
  return std::clamp(static_cast<int>(std::lround(fraction * size)), 0, size);
}

}  // namespace

ProfileMaker::ProfileMaker(const CameraRig& rig, const Region& region, double field_of_view)
    : first_column_(pixelsBefore(region.x_min, rig.width)),
      column_count_(pixelsBefore(region.x_max, rig.width) - first_column_),
      first_row_(pixelsBefore(region.y_min, rig.height)),
      row_count_(pixelsBefore(region.y_max, rig.height) - first_row_) {
  if (column_count_ < 2) return;
  columns_.resize(static_cast<std::size_t>(column_count_));
  if (!rig.calibrated) {
    radians_per_sample_ = field_of_view / rig.width;
    std::iota(columns_.begin(), columns_.end(), 0.0);
    return;
  }
  const Pinhole& K = rig.pinhole;
  const double left = std::atan((first_column_ - K.cx) / K.fx);
  const double right = std::atan((first_column_ + column_count_ - 1 - K.cx) / K.fx);
  radians_per_sample_ = (right - left) / (column_count_ - 1);
  for (int i = 0; i < column_count_; ++i) {
    const double column = K.cx + K.fx * std::tan(left + i * radians_per_sample_);
    columns_[static_cast<std::size_t>(i)] =
        std::clamp(column - first_column_, 0.0, column_count_ - 1.0);
  }
}

Profile ProfileMaker::make(const Image& image) const {
  const int channels = bytesPerPixel(image.format());
  std::vector<std::uint32_t> sums(columns_.size());  // all begin at zero, for every image
  for (int r = first_row_; r < first_row_ + row_count_; ++r) {
    addRow(image.row(r) + first_column_ * channels, channels, sums);
  }
  const double unit = 1.0 / (255.0 * channels * row_count_);
  Profile profile(columns_.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto before = std::min(static_cast<std::size_t>(columns_[i]), sums.size() - 2);
    const double part = columns_[i] - static_cast<double>(before);
    profile[i] = static_cast<float>(unit * ((1 - part) * sums[before] + part * sums[before + 1]));
  }
  return profile;
}

double contrastOf(const Profile& profile) {
  if (profile.empty()) return 0;
  const double count = static_cast<double>(profile.size());
  const double mean = std::accumulate(profile.begin(), profile.end(), 0.0) / count;
  double squares = 0;
  for (const float value : profile) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / count);
}

namespace {

double meanOf(std::span<const float> values) {
  double sum = 0;
  for (const float value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Mean absolute difference after subtracting the means, when the scene moved right by `shift`.
double differenceAt(const Profile& earlier, const Profile& later, int shift) {
  const std::size_t overlap = earlier.size() - static_cast<std::size_t>(std::abs(shift));
  const auto a = std::span(earlier).subspan(shift < 0 ? std::size_t(-shift) : 0, overlap);
  const auto b = std::span(later).subspan(shift > 0 ? std::size_t(shift) : 0, overlap);
  const auto brighter = static_cast<float>(meanOf(b) - meanOf(a));
  double sum = 0;
  for (std::size_t i = 0; i < overlap; ++i) sum += std::abs(b[i] - a[i] - brighter);
  return sum / static_cast<double>(overlap);
}

/// Position of the tip of a V with equal slopes through the costs at -1, 0 and 1; that at 0 is the
/// smallest.
double tipOfV(double before, double least, double after) {
  const double rise = std::max(before, after) - least;
  return rise > 0 ? 0.5 * (before - after) / rise : 0;
}

/// Half the width of the range around `best` with costs below a level between the best and the mean
/// cost, a tenth above the best.
double basin(const std::vector<double>& costs, std::size_t best) {
  double mean = 0;
  for (const double cost : costs) mean += cost / static_cast<double>(costs.size());
  const double level = costs[best] + 0.1 * (mean - costs[best]);  // chosen, not tuned
  std::size_t first = best;
  std::size_t last = best;
  for (std::size_t i = 0; i < costs.size(); ++i) {  // other minima too: any may be the true one
    if (costs[i] > level) continue;
    first = std::min(first, i);
    last = std::max(last, i);
  }
  return 0.5 * static_cast<double>(last - first);
}

}  // namespace

ProfileMatch matchProfiles(const Profile& earlier, const Profile& later, int largest_shift) {
  const int largest = std::min(largest_shift, static_cast<int>(earlier.size() / 2));
  std::vector<double> costs;
  std::size_t best = static_cast<std::size_t>(largest);  // no shift
  for (int shift = -largest; shift <= largest; ++shift) {
    costs.push_back(differenceAt(earlier, later, shift));
  }
  const auto distance = [&](std::size_t i) { return std::abs(static_cast<int>(i) - largest); };
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const bool closer = costs[i] == costs[best] && distance(i) < distance(best);
    if (costs[i] < costs[best] || closer) best = i;
  }
  ProfileMatch match;
  match.moved_right = static_cast<double>(best) - largest;
  match.difference = costs[best];
  match.uncertainty = basin(costs, best);
  match.compared = static_cast<int>(earlier.size()) - distance(best);
  if (best > 0 && best + 1 < costs.size()) {
    match.moved_right += tipOfV(costs[best - 1], costs[best], costs[best + 1]);
  }
  return match;
}

}  // namespace tolman::scanline
