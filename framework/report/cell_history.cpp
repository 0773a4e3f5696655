// SPDX-License-Identifier: BSD-3-Clause
#include "report/cell_history.hpp"

namespace tolman::report {
namespace {

void add(PopulationHistory& history, std::int64_t frame, NamedArray&& array) {
  if (history.empty()) {
    history.name = array.name;
    history.shape = array.shape;
  }
  if (array.name != history.name || array.shape != history.shape) return;
  history.frames.push_back(frame);
  history.activity.push_back(std::move(array.values));
}

}  // namespace

Result<CellHistory> readCells(const record::RunReader& reader,
                              const std::vector<Decision>& decisions) {
  CellHistory history;
  for (const Decision& decision : decisions) {
    auto arrays = reader.arrays(decision.frame, "cells");
    if (!arrays.isOk()) return arrays.status();
    for (NamedArray& array : arrays.value()) {
      if (!array.name.ends_with(".activity") || array.values.empty()) continue;
      if (array.shape.size() == 1)
        add(history.ring, decision.frame, std::move(array));
      else if (array.shape.size() == 2)
        add(history.sheet, decision.frame, std::move(array));
    }
  }
  return history;
}

}  // namespace tolman::report
