// SPDX-License-Identifier: BSD-3-Clause
#include "report/drawn_units.hpp"

#include <fmt/format.h>

namespace tolman::report {
namespace {

std::vector<std::size_t> sizesOf(const PopulationHistory& population) {
  return {population.shape.begin(), population.shape.end()};
}

Status checkChoice(const CellHistory& cells, const UnitChoice& choice) {
  const std::vector<std::size_t> ring = sizesOf(cells.ring);
  const std::size_t directions = ring.empty() ? 0 : ring[0];
  if (choice.head_direction > 0 && choice.head_direction >= directions) {
    return {StatusCode::InvalidParameter,
            fmt::format("there is no head direction unit {}: this run has {}",
                        choice.head_direction + 1, directions)};
  }
  const std::vector<std::size_t> sheet = sizesOf(cells.sheet);
  const std::size_t rows = sheet.empty() ? 0 : sheet[0];
  const std::size_t columns = sheet.empty() ? 0 : sheet[1];
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
    const Walk walk(cells.ring, map);
    const std::size_t size = sizesOf(cells.ring)[0];
    for (const std::size_t turn : {std::size_t{0}, size / 2}) {
      const std::size_t unit = (choice.head_direction + turn) % size;
      units.push_back(
          {Population::Ring, unit,
           fmt::format("head direction unit {} of {}, {} deg", unit + 1, size, 360 * unit / size),
           walk.rates(unit)});
    }
  }
  if (!cells.sheet.empty()) {
    const std::size_t unit = choice.row * sizesOf(cells.sheet)[1] + choice.column;
    units.push_back({Population::Sheet, unit,
                     fmt::format("grid unit ({}, {})", choice.row + 1, choice.column + 1),
                     Walk(cells.sheet, map).rates(unit)});
  }
  return units;
}

}  // namespace tolman::report
