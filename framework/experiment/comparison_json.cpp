// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison_json.hpp"

#include <nlohmann/json.hpp>

#include "config/json_text.hpp"

namespace tolman::experiment {
namespace {

using Json = nlohmann::ordered_json;

Json rangeOf(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return {{"low", interval->low}, {"high", interval->high}};
}

Json differenceOf(const std::optional<PairedDifference>& difference) {
  if (!difference) return nullptr;
  Json json = {{"pairs", difference->pairs},
               {"mean", nullptr},
               {"interval", rangeOf(difference->interval)},
               {"p", nullptr},
               {"effect", nullptr}};
  if (difference->pairs > 0) json["mean"] = difference->mean;
  if (difference->test) {
    json["p"] = difference->test->p;
    json["effect"] = difference->test->effect;
  }
  return json;
}

Json levelOf(const Level& level) {
  const Summary& s = level.summary;
  return {{"label", level.label},   {"runs", s.n},
          {"mean", s.mean},         {"interval", rangeOf(level.interval)},
          {"median", s.median},     {"sd", s.n > 1 ? Json(s.deviation) : Json()},
          {"min", s.low},           {"max", s.high},
          {"values", level.values}, {"difference", differenceOf(level.difference)}};
}

}  // namespace

std::string jsonOf(const Comparison& comparison) {
  Json json = {{"metric", comparison.metric},     {"by", comparison.by},
               {"baseline", comparison.baseline}, {"alignment", comparison.alignment},
               {"levels", Json::array()},         {"notes", comparison.notes}};
  for (const Level& level : comparison.levels) json["levels"].push_back(levelOf(level));
  return config::jsonText(json, 1) + "\n";
}

std::string jsonOf(const TextTable& table) {
  Json json = {{"rows", Json::array()}, {"notes", table.notes}};
  for (const auto& row : table.rows) {
    Json cells = Json::object();
    for (std::size_t k = 0; k < table.heading.size(); ++k) cells[table.heading[k]] = row[k];
    json["rows"].push_back(std::move(cells));
  }
  return config::jsonText(json, 1) + "\n";
}

}  // namespace tolman::experiment
