// SPDX-License-Identifier: BSD-3-Clause
#include "profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

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

}  // namespace tolman::scanline
