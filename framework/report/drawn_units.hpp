// SPDX-License-Identifier: BSD-3-Clause
// Which single units a report draws.
#pragma once

#include <string>
#include <vector>

#include "report/walk.hpp"
#include "tolman/status.hpp"

namespace tolman::report {

/// Counted from 0. Of the ring the opposite unit is drawn as well.
struct UnitChoice {
  std::size_t head_direction = 0;
  std::size_t row = 0;
  std::size_t column = 0;
};

enum class Population : std::uint8_t { Ring, Sheet };

struct DrawnUnit {
  Population population = Population::Ring;
  std::size_t unit = 0;  ///< from 0, row by row
  std::string name;      ///< counts from 1
  RateMap rates;
};

/// First those of the ring, as far as the run has them. InvalidParameter for a unit beyond the
/// run's.
Result<std::vector<DrawnUnit>> drawnUnits(const CellHistory& cells,
                                          const evaluation::Trajectory& map,
                                          const UnitChoice& choice);

}  // namespace tolman::report
