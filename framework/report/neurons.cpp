// SPDX-License-Identifier: BSD-3-Clause
#include "report/neurons.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tolman::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTuningBins = 36;
constexpr std::size_t kChances = 100;  // minimal number of shifted units
constexpr double kShortestShift = 0.05;

std::vector<HeadDirectionUnit> measureRing(const PopulationHistory& ring,
                                           const evaluation::Trajectory& map) {
  std::vector<HeadDirectionUnit> units;
  if (ring.empty()) return units;
  const ActivityPath walk(ring, map);
  for (std::size_t i = 0; i < ring.activity.front().size(); ++i) {
    units.push_back({tuningCurve(walk.samples(i), kTuningBins), spatialInformation(walk.rates(i))});
  }
  return units;
}

GridUnit measureUnit(const RateMap& map) {
  return {spatialInformation(map), fields(map).size(), squarePeriodicity(map)};
}

/// Shares of the path, evenly distributed for any number of them (golden ratio sequence).
double shiftOf(std::size_t i) {
  const double turns = static_cast<double>(i + 1) * std::numbers::phi;
  return kShortestShift + (1 - 2 * kShortestShift) * (turns - std::floor(turns));
}

std::optional<double> chanceOf(const ActivityPath& walk, std::size_t units) {
  std::vector<double> scores;
  for (std::size_t i = 0; i < std::max(units, kChances); ++i) {
    const auto periodicity = squarePeriodicity(walk.rates(i % units, shiftOf(i)));
    if (periodicity) scores.push_back(periodicity->score);
  }
  if (scores.empty()) return std::nullopt;
  const auto place =
      scores.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(scores.size()));
  std::nth_element(scores.begin(), place, scores.end());
  return *place;
}

Json curveJson(const HeadDirectionUnit& unit, const ArrayAxis& axis, std::size_t i) {
  return {{"unit", i + 1},
          {"nominal_deg", axisAngle(axis, i) * kDegrees},
          {"preferred_deg", unit.tuning.preferred * kDegrees},
          {"mean_vector_length", unit.tuning.mean_vector_length},
          {"spatial_information_bits", unit.bits},
          {"tuning", unit.tuning.rate}};
}

Json unitJson(const GridUnit& unit, const ArrayInfo& sheet, std::size_t row, std::size_t column) {
  Json json{{"unit", {row + 1, column + 1}},
            {"nominal", {axisValue(sheet.axes[0], row), axisValue(sheet.axes[1], column)}},
            {"spatial_information_bits", unit.bits},
            {"fields", unit.fields},
            {"periodicity", nullptr}};
  if (unit.periodicity) {
    json["periodicity"] = {{"score", unit.periodicity->score},
                           {"spacing_m", unit.periodicity->spacing},
                           {"direction_deg", unit.periodicity->direction * kDegrees}};
  }
  return json;
}

}  // namespace

double Neurons::periodicShare() const {
  if (sheet.empty() || !chance) return 0;
  const auto above = std::count_if(sheet.begin(), sheet.end(), [this](const GridUnit& unit) {
    return unit.periodicity && unit.periodicity->score > *chance;
  });
  return static_cast<double>(above) / static_cast<double>(sheet.size());
}

Neurons measureNeurons(const CellHistory& cells, const evaluation::Trajectory& map) {
  Neurons neurons;
  neurons.ring = measureRing(cells.ring, map);
  neurons.ring_info = cells.ring.info;
  neurons.sheet_info = cells.sheet.info;
  if (cells.sheet.empty()) return neurons;
  neurons.columns = static_cast<std::size_t>(cells.sheet.shape[1]);
  const ActivityPath walk(cells.sheet, map);
  const std::size_t units = cells.sheet.activity.front().size();
  for (std::size_t i = 0; i < units; ++i) neurons.sheet.push_back(measureUnit(walk.rates(i)));
  neurons.chance = chanceOf(walk, units);
  return neurons;
}

Json toJson(const Neurons& neurons) {
  if (neurons.ring.empty() && neurons.sheet.empty()) return nullptr;
  Json json{{"head_direction", Json::array()},
            {"grid", Json::array()},
            {"grid_chance", nullptr},
            {"grid_share_above_chance", nullptr}};
  for (const HeadDirectionUnit& unit : neurons.ring) {
    json["head_direction"].push_back(
        curveJson(unit, neurons.ring_info.axes[0], json["head_direction"].size()));
  }
  for (std::size_t i = 0; i < neurons.sheet.size(); ++i) {
    json["grid"].push_back(
        unitJson(neurons.sheet[i], neurons.sheet_info, i / neurons.columns, i % neurons.columns));
  }
  if (neurons.chance) {
    json["grid_chance"] = *neurons.chance;
    json["grid_share_above_chance"] = neurons.periodicShare();
  }
  return json;
}

Json toJson(const RateMap& map) {
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
