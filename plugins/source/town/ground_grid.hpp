// SPDX-License-Identifier: BSD-3-Clause
// A regular grid of one value over the ground of the town (a distance or height, m), with bilinear
// interpolation.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tolman::town {

class GroundGrid {
 public:
  GroundGrid() = default;
  GroundGrid(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double cell, float value)
      : low_(low),
        cell_(cell),
        columns_(1 + static_cast<int>(std::ceil((high.x() - low.x()) / cell))),
        rows_(1 + static_cast<int>(std::ceil((high.y() - low.y()) / cell))),
        values_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), value) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double cell() const { return cell_; }
  Eigen::Vector2d position(int column, int row) const {
    return low_ + cell_ * Eigen::Vector2d(column, row);
  }
  float& value(int column, int row) { return values_[index(column, row)]; }
  float value(int column, int row) const { return values_[index(column, row)]; }

  /// Bilinear interpolation; outside of the grid the value at its edge. 0 for an empty grid.
  double at(double x, double y) const {
    if (values_.empty()) return 0;
    const double c = std::clamp((x - low_.x()) / cell_, 0.0, columns_ - 1.0);
    const double r = std::clamp((y - low_.y()) / cell_, 0.0, rows_ - 1.0);
    const int c0 = std::min(static_cast<int>(c), std::max(columns_ - 2, 0));
    const int r0 = std::min(static_cast<int>(r), std::max(rows_ - 2, 0));
    const int c1 = std::min(c0 + 1, columns_ - 1);
    const int r1 = std::min(r0 + 1, rows_ - 1);
    const double fc = c - c0;
    const double fr = r - r0;
    return (1 - fr) * ((1 - fc) * value(c0, r0) + fc * value(c1, r0)) +
           fr * ((1 - fc) * value(c0, r1) + fc * value(c1, r1));
  }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  double cell_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> values_;
};

}  // namespace tolman::town
