// SPDX-License-Identifier: BSD-3-Clause
// Measurements of every head direction unit and every grid unit of a run: tuning curve, spatial
// information, fields and periodicity of the firing rate along the path of the map.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "report/activity_path.hpp"
#include "report/periodicity.hpp"

namespace tolman::report {

struct HeadDirectionUnit {
  TuningCurve tuning;
  double bits = 0;  ///< spatialInformation()
};

struct GridUnit {
  double bits = 0;  ///< spatialInformation()
  std::size_t fields = 0;
  std::optional<Periodicity> periodicity;  ///< none where the path is too narrow
};

struct Neurons {
  std::vector<HeadDirectionUnit> ring;
  std::vector<GridUnit> sheet;  ///< row by row
  std::size_t columns = 0;      ///< of the sheet
  ArrayInfo ring_info;
  ArrayInfo sheet_info;
  /// The 95th percentile of the periodicity score of units whose activity is shifted in time
  /// against the path; none where there is no score.
  std::optional<double> chance;

  /// The share of grid units that score above chance.
  double periodicShare() const;
};

Neurons measureNeurons(const CellHistory& cells, const evaluation::Trajectory& map);

/// Angles in degrees, unit indices from 1; `nominal` is what the unit stands for by its
/// description. Null without cells.
nlohmann::ordered_json toJson(const Neurons& neurons);
/// A rate map as rows from its corner to the right, null in bins without visits.
nlohmann::ordered_json toJson(const RateMap& map);

}  // namespace tolman::report
