// SPDX-License-Identifier: BSD-3-Clause
#include "plots.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::town {
namespace {

constexpr double kBookCell = 50;  // m; so large that a plot is only in neighbouring cells

std::int64_t bookKey(std::int64_t x, std::int64_t y) { return (x << 32) ^ (y & 0xffffffff); }
std::int64_t bookCell(double x) { return static_cast<std::int64_t>(std::floor(x / kBookCell)); }

/// Whether an axis of `a` separates the two rectangles.
bool separatedBy(const Plot& a, const Plot& b) {
  const Eigen::Vector2d offset = b.centre - a.centre;
  const auto reach = [&](const Eigen::Vector2d& direction) {
    return b.half_length * std::abs(direction.dot(b.axis)) +
           b.half_depth * std::abs(direction.dot(b.across()));
  };
  return std::abs(offset.dot(a.axis)) > a.half_length + reach(a.axis) ||
         std::abs(offset.dot(a.across())) > a.half_depth + reach(a.across());
}

}  // namespace

bool overlap(const Plot& a, const Plot& b) { return !separatedBy(a, b) && !separatedBy(b, a); }

bool PlotBook::clearOfStreets(const Plot& plot, double clearance) const {
  // Samples 1.5 m apart cover the plot; a street is wider than their distance.
  const int columns = 1 + static_cast<int>(std::ceil(plot.half_length / 0.75));
  const int rows = 1 + static_cast<int>(std::ceil(plot.half_depth / 0.75));
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double along = plot.half_length * (2.0 * i / (columns - 1) - 1);
      const double over = plot.half_depth * (2.0 * j / (rows - 1) - 1);
      const Eigen::Vector2d p = plot.point(along, over);
      if (plan_->distance(p.x(), p.y()) < clearance) return false;
    }
  }
  return true;
}

bool PlotBook::enter(const Plot& plot, double clearance) {
  if (!clearOfStreets(plot, clearance)) return false;
  const std::int64_t x = bookCell(plot.centre.x());
  const std::int64_t y = bookCell(plot.centre.y());
  for (std::int64_t i = x - 1; i <= x + 1; ++i) {
    for (std::int64_t j = y - 1; j <= y + 1; ++j) {
      const auto cell = cells_.find(bookKey(i, j));
      if (cell == cells_.end()) continue;
      const auto hit = [&](const Plot& other) { return overlap(plot, other); };
      if (std::any_of(cell->second.begin(), cell->second.end(), hit)) return false;
    }
  }
  cells_[bookKey(x, y)].push_back(plot);
  return true;
}

}  // namespace tolman::town
