// SPDX-License-Identifier: BSD-3-Clause
#include "shadow_grid.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::town {
namespace {

constexpr float kFinest = 0.5F;         // m
constexpr float kMostCells = 16e6F;     // of one byte
constexpr float kLowestSun = 0.1F;      // sine of its elevation
constexpr float kShadowMargin = 0.03F;  // m, more than rounding at the far end of a town

constexpr std::array<std::array<std::uint8_t, 2>, 3> kTriangle = {{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<std::array<std::uint8_t, 2>, 12> kBox = {{{0, 1},
                                                               {2, 3},
                                                               {4, 5},
                                                               {6, 7},
                                                               {0, 2},
                                                               {1, 3},
                                                               {4, 6},
                                                               {5, 7},
                                                               {0, 4},
                                                               {1, 5},
                                                               {2, 6},
                                                               {3, 7}}};

}  // namespace

void ShadowGrid::start(const Vec3& to_sun, const GroundArea& area) {
  stop();
  moving_.clear();
  if (to_sun.z < kLowestSun) return;
  along_x_ = to_sun.x / to_sun.z;
  along_y_ = to_sun.y / to_sun.z;
  low_x_ = area.low.x;
  low_y_ = area.low.y;
  const float width = area.high.x - area.low.x;
  const float height = area.high.y - area.low.y;
  if (width <= 0 || height <= 0) return;
  const float cell = std::max(kFinest, std::sqrt(width * height / kMostCells));
  per_m_ = 1 / cell;
  columns_ = 1 + static_cast<int>(width / cell);
  rows_ = 1 + static_cast<int>(height / cell);
  cells_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
}

ShadowGrid::Flat ShadowGrid::alongLight(const Vec3& p) const {
  return {(p.x - along_x_ * p.z - low_x_) * per_m_, (p.y - along_y_ * p.z - low_y_) * per_m_};
}

void ShadowGrid::mark(const std::array<Vec3, 3>& corners) {
  if (!isOn()) return;
  std::array<Flat, 3> flat;
  for (std::size_t i = 0; i < flat.size(); ++i) flat[i] = alongLight(corners[i]);
  markHull(flat, kTriangle, kFixed);
}

void ShadowGrid::mark(const std::array<Vec3, 8>& corners, bool is_moving) {
  if (!isOn()) return;
  std::array<Flat, 8> flat;
  for (std::size_t i = 0; i < flat.size(); ++i) flat[i] = alongLight(corners[i]);
  markHull(flat, kBox, is_moving ? kMoving : kPlaced);
}

/// In each row from the leftmost to the rightmost point of the edges.
void ShadowGrid::markHull(std::span<const Flat> points,
                          std::span<const std::array<std::uint8_t, 2>> edges, std::uint8_t caster) {
  const float margin = kShadowMargin * per_m_;
  const auto below = [](const Flat& a, const Flat& b) { return a.v < b.v; };
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), below);
  const float top = static_cast<float>(rows_ - 1);
  const int first = static_cast<int>(std::clamp(lowest->v - margin, 0.0F, top));
  const int last = static_cast<int>(std::clamp(highest->v + margin, -1.0F, top));
  for (int row = first; row <= last; ++row) {
    const float from = static_cast<float>(row) - margin;
    const float to = static_cast<float>(row + 1) + margin;
    float low = static_cast<float>(columns_);
    float high = -1;
    for (const auto& [i, j] : edges) {
      const Flat& a = below(points[i], points[j]) ? points[i] : points[j];
      const Flat& b = below(points[i], points[j]) ? points[j] : points[i];
      if (b.v < from || a.v > to) continue;
      const float slope = b.v > a.v ? (b.u - a.u) / (b.v - a.v) : 0;
      const float ua = a.v < from ? a.u + slope * (from - a.v) : a.u;
      const float ub = b.v > to ? a.u + slope * (to - a.v) : b.u;
      low = std::min({low, ua, ub});
      high = std::max({high, ua, ub});
    }
    markRun(row, low - margin, high + margin, caster);
  }
}

void ShadowGrid::markRun(int row, float low, float high, std::uint8_t caster) {
  if (high < 0 || low >= static_cast<float>(columns_) || high < low) return;
  const float right = static_cast<float>(columns_ - 1);
  const auto first = static_cast<std::size_t>(std::clamp(low, 0.0F, right));
  const auto last = static_cast<std::size_t>(std::clamp(high, 0.0F, right));
  const std::size_t begin =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + first;
  const Run run = {begin, last - first + 1};
  for (std::size_t i = run.first; i < run.first + run.count; ++i) cells_[i] |= caster;
  if (caster == kMoving) moving_.push_back(run);
}

void ShadowGrid::forgetMoving() {
  for (const Run& run : moving_) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      cells_[i] &= static_cast<std::uint8_t>(~kMoving);
    }
  }
  moving_.clear();
}

}  // namespace tolman::town
