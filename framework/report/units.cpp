// SPDX-License-Identifier: BSD-3-Clause
#include "report/units.hpp"

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
  const auto one = unitsAt(ring, poses, {unit}, run.metrics.cells->truth);
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
  const auto one = unitsAt(sheet, poses, {unit}, run.metrics.cells->truth);
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

using Json = nlohmann::ordered_json;
using evaluation::axisAngle;
using evaluation::axisValue;
using evaluation::kDegrees;
using evaluation::PopulationHistory;

Json ringUnitJson(const PopulationHistory& ring, std::size_t i, const evaluation::RingUnit& unit) {
  const auto& width = unit.tuning.half_width;
  return {{"array", ring.info.name},
          {"unit", i + 1},
          {"nominal_deg", axisAngle(ring.info.axes[0], i) * kDegrees},
          {"preferred_deg", unit.tuning.preferred * kDegrees},
          {"mean_vector_length", unit.tuning.mean_vector_length},
          {"half_width_deg", width ? Json(*width * kDegrees) : Json()},
          {"spatial_information_bits", unit.information_bits},
          {"tuning", unit.tuning.rate}};
}

Json sheetUnitJson(const PopulationHistory& sheet, std::size_t i,
                   const evaluation::SheetUnit& unit) {
  const auto columns = static_cast<std::size_t>(sheet.shape[1]);
  const std::size_t row = i / columns;
  const std::size_t column = i % columns;
  const auto& axes = sheet.info.axes;
  Json json{{"array", sheet.info.name},
            {"unit", {row + 1, column + 1}},
            {"nominal", {axisValue(axes[0], row), axisValue(axes[1], column)}},
            {"spatial_information_bits", unit.information_bits},
            {"fields", unit.fields}};
  const auto score = [&](const char* key, double evaluation::GridScores::*member) {
    json[key] = unit.scores ? Json((*unit.scores).*member) : Json();
  };
  score("grid_score_square", &evaluation::GridScores::square);
  score("grid_score_sargolini", &evaluation::GridScores::sargolini);
  score("grid_score_langston", &evaluation::GridScores::langston);
  score("spacing_m", &evaluation::GridScores::spacing);
  score("ellipticity", &evaluation::GridScores::ellipticity);
  score("orientation_rad", &evaluation::GridScores::orientation);
  const auto other = [&](const char* key, const std::optional<double>& value) {
    json[key] = value ? Json(*value) : Json();
  };
  other("sparsity", unit.sparsity);
  other("coherence", unit.coherence);
  other("border_score", unit.border);
  other("speed_score", unit.speed);
  return json;
}

/// Collects unit_json(population, index, unit) for all measured units of all populations.
template <class Figures, class UnitJson>
Json unitsJson(const std::vector<PopulationHistory>& populations,
               const std::vector<Figures>& figures, UnitJson&& unit_json) {
  Json list = Json::array();
  for (std::size_t p = 0; p < populations.size(); ++p) {
    const std::vector<std::size_t> measured = measuredUnits(populations[p]);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      list.push_back(unit_json(populations[p], measured[i], figures[p].scores.units[i]));
    }
  }
  return list;
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

Json neuronsJson(const RunData& run, const std::vector<DrawnUnit>& drawn) {
  if (!run.metrics.cells) return nullptr;
  const evaluation::CellFigures& figures = *run.metrics.cells;
  Json json{{"places", figures.truth ? "truth" : "map"},
            {"head_direction", unitsJson(run.cells.rings, figures.rings, ringUnitJson)},
            {"grid", unitsJson(run.cells.sheets, figures.sheets, sheetUnitJson)},
            {"rate_maps", Json::object()}};
  for (const DrawnUnit& unit : drawn) json["rate_maps"][unit.name] = toJson(unit.rates);
  return json;
}

Json toJson(const evaluation::RateMap& map) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < map.rate.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < map.rate.cols(); ++j) {
      row.push_back(map.visits(i, j) > 0 ? Json(map.rate(i, j)) : Json(nullptr));
    }
    rows.push_back(std::move(row));
  }
  return {{"corner_m", {map.corner.x(), map.corner.y()}}, {"bin_m", map.bin}, {"rate", rows}};
}

}  // namespace tolman::report
