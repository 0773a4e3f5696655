// SPDX-License-Identifier: BSD-3-Clause
// Stores the templates as a structure of arrays: all cells in one contiguous buffer of fixed-point
// numbers, all means in another. Memory grows by amortised doubling.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "view_maker.hpp"

namespace tolman::view_templates {

/// A cell in fixed point: [0, 1] on 0 ... kOne. Fifteen bits, so that sums of differences are exact
/// integers (the same on every machine) and eight fit in a baseline vector register.
using FixedCell = std::int16_t;
inline constexpr int kOne = 32767;

FixedCell toFixed(float cell);

class TemplateBank {
 public:
  TemplateBank(int columns, int rows) : columns_(columns), rows_(rows) {}

  /// Stores a view; its id is the number of templates before it.
  std::int64_t add(const LocalView& view);
  std::int64_t size() const { return static_cast<std::int64_t>(means_.size()); }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t cellsPerTemplate() const { return static_cast<std::size_t>(columns_ * rows_); }

  std::span<const FixedCell> cells(std::int64_t id) const {
    return {cells_.data() + static_cast<std::size_t>(id) * cellsPerTemplate(), cellsPerTemplate()};
  }
  double mean(std::int64_t id) const { return means_[static_cast<std::size_t>(id)]; }

  std::span<const FixedCell> allCells() const { return cells_; }
  std::span<const double> allMeans() const { return means_; }
  void clear();
  /// Restores the values of allCells() and allMeans(); their sizes must agree.
  void restore(std::vector<FixedCell> cells, std::vector<double> means);

 private:
  int columns_;
  int rows_;
  std::vector<FixedCell> cells_;
  std::vector<double> means_;
};

}  // namespace tolman::view_templates
