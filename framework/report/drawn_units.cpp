// SPDX-License-Identifier: BSD-3-Clause
#include "report/drawn_units.hpp"

#include <fmt/format.h>

namespace tolman::report {
namespace {

using evaluation::axisAngle;
using evaluation::axisValue;
using evaluation::kDegrees;
using evaluation::PopulationHistory;

constexpr evaluation::Shuffling kNoShuffling{0, 1, 1};

/// Size of an axis of the first population; 0 without one.
std::size_t sizeOf(const std::vector<PopulationHistory>& populations, std::size_t axis) {
  return populations.empty() ? 0 : static_cast<std::size_t>(populations[0].shape[axis]);
}

evaluation::RateMap inMetres(evaluation::RateMap map, const RunData& run) {
  map.corner *= run.metres;
  map.bin *= run.metres;
  return map;
}

DrawnUnit headDirectionUnit(const RunData& run, std::size_t unit,
                            const evaluation::StampedPoses& poses) {
  const PopulationHistory& ring = run.cells.rings[0];
  const auto one = unitsAt(ring, poses, {unit});
  const evaluation::TuningCurve curve = scoreRing(one, kNoShuffling).units[0].tuning;
  const std::string width =
      curve.half_width ? fmt::format(", half width {:.0f} deg", *curve.half_width * kDegrees) : "";
  return {fmt::format("head direction unit {} of {}, {:.3g} deg", unit + 1, ring.shape[0],
                      axisAngle(ring.info.axes[0], unit) * kDegrees),
          fmt::format("mean vector length {:.2f} towards {:.0f} deg{}", curve.mean_vector_length,
                      curve.preferred * kDegrees, width),
          inMetres(firingMap(one, 0), run),
          {}};
}

DrawnUnit gridUnit(const RunData& run, const UnitChoice& choice,
                   const evaluation::StampedPoses& poses) {
  const PopulationHistory& sheet = run.cells.sheets[0];
  const auto& axes = sheet.info.axes;
  const std::size_t unit = choice.row * sizeOf(run.cells.sheets, 1) + choice.column;
  const auto one = unitsAt(sheet, poses, {unit});
  const auto measured = scoreSheet(one, periodInMetres(sheet), kNoShuffling).units[0];
  const auto lattice = evaluation::bestLattice(run.metrics.cells->sheets[0].scores);
  const std::string score =
      measured.scores && lattice.score
          ? fmt::format(", {} score {:.2f} (chance {:.2f})", lattice.name,
                        (*measured.scores).*lattice.of_unit, lattice.score->chance)
          : ", too narrow an area for grid scores";
  DrawnUnit drawn{fmt::format("grid unit ({}, {}), phase ({:.3g}, {:.3g}) {}", choice.row + 1,
                              choice.column + 1, axisValue(axes[0], choice.row),
                              axisValue(axes[1], choice.column), axes[0].unit),
                  fmt::format("{} field{}, {:.2f} bits{}", measured.fields,
                              measured.fields == 1 ? "" : "s", measured.information_bits, score),
                  inMetres(firingMap(one, 0), run),
                  {}};
  drawn.fields = evaluation::fields(drawn.rates);
  return drawn;
}

Status checkChoice(const evaluation::CellHistory& cells, const UnitChoice& choice) {
  std::string refusal;
  const std::size_t directions = sizeOf(cells.rings, 0);
  if (choice.head_direction > 0 && choice.head_direction >= directions) {
    refusal = fmt::format("there is no head direction unit {}: this run has {}",
                          choice.head_direction + 1, directions);
  }
  const std::size_t rows = sizeOf(cells.sheets, 0);
  const std::size_t columns = sizeOf(cells.sheets, 1);
  if (choice.row + choice.column > 0 && (choice.row >= rows || choice.column >= columns)) {
    refusal = fmt::format("there is no grid unit {},{}: this run has {} by {}", choice.row + 1,
                          choice.column + 1, rows, columns);
  }
  return refusal.empty() ? Status::ok() : Status(StatusCode::InvalidParameter, refusal);
}

}  // namespace

Result<std::vector<DrawnUnit>> drawnUnits(const RunData& run, const UnitChoice& choice) {
  const Status possible = checkChoice(run.cells, choice);
  if (!possible.isOk()) return possible;
  std::vector<DrawnUnit> units;
  const auto poses = evaluation::stampedPosesOf(run.places());
  if (poses.empty()) return units;
  if (!run.cells.rings.empty()) {
    const std::size_t size = sizeOf(run.cells.rings, 0);
    for (const std::size_t turn : {std::size_t{0}, size / 2}) {
      const std::size_t unit = (choice.head_direction + turn) % size;
      units.push_back(headDirectionUnit(run, unit, poses));
    }
  }
  if (!run.cells.sheets.empty()) units.push_back(gridUnit(run, choice, poses));
  return units;
}

}  // namespace tolman::report
