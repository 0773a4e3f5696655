// SPDX-License-Identifier: BSD-3-Clause
// Regular grids of one value over the ground of the town: distance to the streets, height.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "street_path.hpp"

namespace tolman::town {

/// The rectangle that a grid covers.
struct GridExtent {
  Eigen::Vector2d low;   ///< m
  Eigen::Vector2d high;  ///< m
};

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
  GridExtent extent() const { return {low_, position(columns_ - 1, rows_ - 1)}; }
  Eigen::Vector2d position(int column, int row) const {
    return low_ + cell_ * Eigen::Vector2d(column, row);
  }
  float& value(int column, int row) { return values_[index(column, row)]; }
  float value(int column, int row) const { return values_[index(column, row)]; }

  /// Calls body(column, row) for the points of the grid, row by row.
  template <class Body>
  void forEach(const Body& body) const {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) body(column, row);
    }
  }
  /// The same for the points at most `reach` m from a place along each axis, and a few more.
  template <class Body>
  void forEachNear(const Eigen::Vector2d& place, double reach, const Body& body) const {
    const Eigen::Vector2d at = (place - low_) / cell_;
    const int radius = static_cast<int>(std::ceil(reach / cell_)) + 1;
    const int column = static_cast<int>(at.x());
    const int row = static_cast<int>(at.y());
    for (int r = std::max(row - radius, 0); r <= std::min(row + radius, rows_ - 1); ++r) {
      for (int c = std::max(column - radius, 0); c <= std::min(column + radius, columns_ - 1);
           ++c) {
        body(c, r);
      }
    }
  }

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

/// Distance to the nearest centreline, m, at most `farthest`, exact at the grid points. Cells are
/// of 0.5 m, or larger if more than 64 MB would be needed.
GroundGrid distanceGrid(const std::vector<PathPoint>& path, const GridExtent& extent,
                        double farthest);

/// Heights of the road at the points of the path, m. Where passes overlap, they are corrected to
/// the mean; corrections change smoothly along the street.
std::vector<double> agreeOnHeights(const std::vector<PathPoint>& path);

/// Height of the ground, m: that of the streets, level across, and a membrane between the streets
/// that approaches `mean` + farHills() far from them. Cells are of 1 m or larger, so 16 MB at most.
GroundGrid heightGrid(const std::vector<PathPoint>& path, const std::vector<double>& heights,
                      const GroundGrid& distance, const GridExtent& extent, double mean,
                      const std::vector<GroundPad>& pads = {});

/// Height of the hills far from streets, m.
double farHills(double x, double y);

}  // namespace tolman::town
