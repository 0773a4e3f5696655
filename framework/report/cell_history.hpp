// SPDX-License-Identifier: BSD-3-Clause
// The recorded arrays of the spatial cells over a run, told apart by their descriptions
// (ArrayInfo).
#pragma once

#include <cstdint>
#include <vector>

#include "record/run_reader.hpp"

namespace tolman::report {

/// One array at the frames where it was recorded.
struct PopulationHistory {
  ArrayInfo info;  ///< the name alone where the array has no description
  std::vector<int> shape;
  std::vector<std::int64_t> frames;
  std::vector<std::vector<float>> activity;  ///< one row per frame, as large as the shape
  std::size_t stride = 1;                    ///< of `others`: every stride-th array was kept
  std::size_t seen = 0;

  bool empty() const { return frames.empty(); }
};

struct CellHistory {
  PopulationHistory ring;   ///< head direction: the first activity over one periodic axis
  PopulationHistory sheet;  ///< grid: the first activity over two axes
  std::vector<PopulationHistory> others;  ///< all other arrays, at 240 frames at most
};

/// Reads the arrays at the frames of `decisions`.
Result<CellHistory> readCells(const record::RunReader& reader,
                              const std::vector<Decision>& decisions);

/// What index `i` of an axis stands for, within [0, period) of a periodic axis.
double axisValue(const ArrayAxis& axis, std::size_t i);
/// The same in radians, for an axis of angles in "deg" or "rad".
double axisAngle(const ArrayAxis& axis, std::size_t i);

}  // namespace tolman::report
