// SPDX-License-Identifier: BSD-3-Clause
// The neural activity over a run: one ring (head direction) and one sheet (grid).
#pragma once

#include <cstdint>
#include <vector>

#include "record/run_reader.hpp"

namespace tolman::report {

/// Activity of a population at the frames where it was recorded; a row a frame.
struct PopulationHistory {
  std::string name;
  std::vector<int> shape;
  std::vector<std::int64_t> frames;
  std::vector<std::vector<float>> activity;  ///< each as large as the shape

  bool empty() const { return frames.empty(); }
};

struct CellHistory {
  PopulationHistory ring;
  PopulationHistory sheet;
};

/// At the frames of `decisions`: the first arrays of the cells whose names end in ".activity", of
/// one and of two dimensions.
Result<CellHistory> readCells(const record::RunReader& reader,
                              const std::vector<Decision>& decisions);

}  // namespace tolman::report
