// SPDX-License-Identifier: BSD-3-Clause
// The units whose firing rate maps a report draws.
#pragma once

#include <string>
#include <vector>

#include "report/activity_path.hpp"
#include "tolman/status.hpp"

namespace tolman::report {

/// Indices from 0. Of the head direction ring the opposite unit is drawn as well.
struct UnitChoice {
  std::size_t head_direction = 0;
  std::size_t row = 0;
  std::size_t column = 0;
};

enum class Population : std::uint8_t { Ring, Sheet };

struct DrawnUnit {
  Population population = Population::Ring;
  std::size_t unit = 0;  ///< from 0, row by row
  std::string name;      ///< with indices from 1
  RateMap rates;
  std::string phase;  ///< of a grid unit: what its indices stand for, "(0, 2.5) m"
};

/// Units of the ring first. InvalidParameter for a unit that the run does not have.
Result<std::vector<DrawnUnit>> drawnUnits(const CellHistory& cells,
                                          const evaluation::Trajectory& map,
                                          const UnitChoice& choice);

}  // namespace tolman::report
