// SPDX-License-Identifier: BSD-3-Clause
// The units whose firing rate maps a report draws, and neurons.json: the firing of every measured
// unit of a run.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "evaluation/recorded_cells.hpp"
#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::report {

/// The units to draw, by indices from 0 in the first ring and the first sheet. For the ring the
/// unit of the opposite heading is drawn as well.
struct UnitChoice {
  std::size_t head_direction = 0;
  std::size_t row = 0;
  std::size_t column = 0;
};

struct DrawnUnit {
  std::string name;      ///< with indices from 1
  std::string measures;  ///< in words
  evaluation::RateMap rates;
  std::vector<Eigen::Vector2d> fields;  ///< centres of the fields of a grid unit
};

/// Units of the ring first. InvalidParameter for a unit that the run does not have.
Result<std::vector<DrawnUnit>> drawnUnits(const RunData& run, const UnitChoice& choice);

/// Angles in degrees, unit indices from 1; `nominal` is the value of the unit by the description of
/// its axis. Null without units.
nlohmann::ordered_json neuronsJson(const RunData& run, const std::vector<DrawnUnit>& drawn);
/// A rate map as rows from its corner to the right, null in bins without visits.
nlohmann::ordered_json toJson(const evaluation::RateMap& map);

}  // namespace tolman::report
