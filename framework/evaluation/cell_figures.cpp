// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/cell_figures.hpp"

namespace tolman::evaluation {
namespace {

using Json = nlohmann::ordered_json;

Json reasonJson(const std::string& reason) { return reason.empty() ? Json() : Json(reason); }

Json errorJson(const std::optional<ErrorFigures>& error, const std::string& unit) {
  return {{"median_" + unit, error ? Json(error->median) : Json()},
          {"p90_" + unit, error ? Json(error->p90) : Json()},
          {"frames", error ? error->count : 0}};
}

Json scoreJson(const std::optional<UnitScore>& score) {
  if (!score) return nullptr;
  return {{"median", score->median},
          {"chance", score->chance},
          {"shuffled_median", score->shuffled_median},
          {"share_above_chance", score->share_better}};
}

Json ringJson(const RingFigures& ring) {
  return {{"array", ring.array},
          {"units", ring.units},
          {"error", errorJson(ring.error_deg, "deg")},
          {"mean_vector_length", scoreJson(ring.scores.mean_vector_length)},
          {"half_width_deg", scoreJson(ring.scores.half_width_deg)},
          {"spatial_information_bits", scoreJson(ring.scores.information_bits)}};
}

Json sheetJson(const SheetFigures& sheet) {
  return {{"array", sheet.array},
          {"units", sheet.units},
          {"period", sheet.period},
          {"period_unit", sheet.unit},
          {"grid_score_square", scoreJson(sheet.scores.square)},
          {"grid_score_sargolini", scoreJson(sheet.scores.sargolini)},
          {"grid_score_langston", scoreJson(sheet.scores.langston)},
          {"spatial_information_bits", scoreJson(sheet.scores.information_bits)}};
}

}  // namespace

Json toJson(const CellFigures& cells) {
  Json position = errorJson(cells.position_m, "m");
  position["modulo_m"] = cells.modulo_m > 0 ? Json(cells.modulo_m) : Json();
  position["reason"] = reasonJson(cells.position_reason);
  Json json{{"places", cells.truth ? "truth" : "map"},
            {"reason", reasonJson(cells.reason)},
            {"position_error", std::move(position)},
            {"head_direction", Json::array()},
            {"grid", Json::array()},
            {"shuffles", cells.shuffles},
            {"least_shift_s", cells.least_shift_s},
            {"seed", cells.seed}};
  for (const RingFigures& ring : cells.rings) json["head_direction"].push_back(ringJson(ring));
  for (const SheetFigures& sheet : cells.sheets) json["grid"].push_back(sheetJson(sheet));
  return json;
}

}  // namespace tolman::evaluation
