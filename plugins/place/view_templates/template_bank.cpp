// SPDX-License-Identifier: BSD-3-Clause
#include "template_bank.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace tolman::view_templates {

FixedCell toFixed(float cell) { return static_cast<FixedCell>(std::lround(cell * kOne)); }

std::int64_t TemplateBank::add(const LocalView& view) {
  if (view.cells.size() != cellsPerTemplate()) throw std::invalid_argument("view of another size");
  for (const float cell : view.cells) cells_.push_back(toFixed(cell));
  means_.push_back(view.mean);
  return size() - 1;
}

void TemplateBank::clear() {
  cells_.clear();
  means_.clear();
}

void TemplateBank::restore(std::vector<FixedCell> cells, std::vector<double> means) {
  if (cells.size() != means.size() * cellsPerTemplate()) {
    throw std::invalid_argument("as many cells as the means need");
  }
  cells_ = std::move(cells);
  means_ = std::move(means);
}

}  // namespace tolman::view_templates
