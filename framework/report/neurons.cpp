// SPDX-License-Identifier: BSD-3-Clause
#include "report/neurons.hpp"

namespace tolman::report {
namespace {

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
