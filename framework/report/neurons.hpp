// SPDX-License-Identifier: BSD-3-Clause
// What is measured of every head direction unit and every grid unit of a run.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "report/periodicity.hpp"
#include "report/walk.hpp"

namespace tolman::report {

struct HeadDirectionUnit {
  TuningCurve tuning;
  double bits = 0;  ///< spatialInformation()
};

struct GridUnit {
  double bits = 0;  ///< spatialInformation()
  std::size_t fields = 0;
  std::optional<Periodicity> periodicity;  ///< none where the way is too narrow to tell
};

struct Neurons {
  std::vector<HeadDirectionUnit> ring;
  std::vector<GridUnit> sheet;  ///< row by row
  std::size_t columns = 0;      ///< of the sheet
  /// The score of periodicity that 95 % of the sheet's units stay below when their activity is
  /// shifted in time against the way; none where there is no score.
  std::optional<double> chance;

  /// The share of grid units that score above chance.
  double periodicShare() const;
};

Neurons measureNeurons(const CellHistory& cells, const evaluation::Trajectory& map);

/// All of it in degrees, units counted from 1; null without cells.
nlohmann::ordered_json toJson(const Neurons& neurons);
/// A rate map as rows from its corner to the right, null where nobody was.
nlohmann::ordered_json toJson(const RateMap& map);

}  // namespace tolman::report
