// SPDX-License-Identifier: BSD-3-Clause
#include "report/drawn_units.hpp"

#include <fmt/format.h>

namespace tolman::report {
namespace {

/// Size of an axis; 0 for an empty population.
std::size_t sizeOf(const PopulationHistory& population, std::size_t axis) {
  return population.empty() ? 0 : static_cast<std::size_t>(population.shape[axis]);
}

/// "(0, 2.5) m".
std::string phaseText(const ArrayInfo& sheet, const UnitChoice& choice) {
  const std::string unit = sheet.axes[0].unit.empty() ? "" : " " + sheet.axes[0].unit;
  return fmt::format("({:.3g}, {:.3g}){}", axisValue(sheet.axes[0], choice.row),
                     axisValue(sheet.axes[1], choice.column), unit);
}

Status checkChoice(const CellHistory& cells, const UnitChoice& choice) {
  const std::size_t directions = sizeOf(cells.ring, 0);
  if (choice.head_direction > 0 && choice.head_direction >= directions) {
    return {StatusCode::InvalidParameter,
            fmt::format("there is no head direction unit {}: this run has {}",
                        choice.head_direction + 1, directions)};
  }
  const std::size_t rows = sizeOf(cells.sheet, 0);
  const std::size_t columns = sizeOf(cells.sheet, 1);
  if (choice.row + choice.column > 0 && (choice.row >= rows || choice.column >= columns)) {
    return {StatusCode::InvalidParameter,
            fmt::format("there is no grid unit {},{}: this run has {} by {}", choice.row + 1,
                        choice.column + 1, rows, columns)};
  }
  return Status::ok();
}

}  // namespace

Result<std::vector<DrawnUnit>> drawnUnits(const CellHistory& cells,
                                          const evaluation::Trajectory& map,
                                          const UnitChoice& choice) {
  const Status possible = checkChoice(cells, choice);
  if (!possible.isOk()) return possible;
  std::vector<DrawnUnit> units;
  if (map.empty()) return units;
  if (!cells.ring.empty()) {
    const ActivityPath walk(cells.ring, map);
    const ArrayAxis& axis = cells.ring.info.axes[0];
    const std::size_t size = sizeOf(cells.ring, 0);
    for (const std::size_t turn : {std::size_t{0}, size / 2}) {
      const std::size_t unit = (choice.head_direction + turn) % size;
      units.push_back({Population::Ring, unit,
                       fmt::format("head direction unit {} of {}, {:.3g} deg", unit + 1, size,
                                   axisAngle(axis, unit) * kDegrees),
                       walk.rates(unit), ""});
    }
  }
  if (!cells.sheet.empty()) {
    const std::size_t unit = choice.row * sizeOf(cells.sheet, 1) + choice.column;
    units.push_back({Population::Sheet, unit,
                     fmt::format("grid unit ({}, {})", choice.row + 1, choice.column + 1),
                     ActivityPath(cells.sheet, map).rates(unit),
                     phaseText(cells.sheet.info, choice)});
  }
  return units;
}

}  // namespace tolman::report
