// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "base/must.hpp"
#include "report/figures.hpp"

namespace tolman::report {
namespace {

using Json = nlohmann::ordered_json;
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
  const auto measured = scoreSheet(one, periodInMetres(sheet), kNoShuffling);
  const auto& all = run.metrics.cells->sheets[0].scores;
  const auto& value = measured.units[0].scores;
  const evaluation::Lattice lattice = evaluation::bestLattice(all);
  const std::string score =
      value[lattice.score] && all.scores[lattice.score]
          ? fmt::format(", {} score {:.2f} (chance {:.2f})", lattice.name, *value[lattice.score],
                        all.scores[lattice.score]->chance)
          : ", too narrow an area for grid scores";
  const std::size_t count = measured.units[0].fields;
  DrawnUnit drawn{fmt::format("grid unit ({}, {}), phase ({:.3g}, {:.3g}) {}", choice.row + 1,
                              choice.column + 1, axisValue(axes[0], choice.row),
                              axisValue(axes[1], choice.column), axes[0].unit),
                  fmt::format("{} field{}, {:.2f} bits{}", count, count == 1 ? "" : "s",
                              *value[all.indexOf("spatial_information_bits")], score),
                  inMetres(firingMap(one, 0), run),
                  {}};
  drawn.fields = evaluation::fields(drawn.rates);
  return drawn;
}

void checkChoice(const evaluation::CellHistory& cells, const UnitChoice& choice) {
  const std::size_t directions = sizeOf(cells.rings, 0);
  if (choice.head_direction > 0 && choice.head_direction >= directions) {
    must(Status::invalidParameter(fmt::format("there is no head direction unit {}: this run has {}",
                                              choice.head_direction + 1, directions)));
  }
  const std::size_t rows = sizeOf(cells.sheets, 0), columns = sizeOf(cells.sheets, 1);
  if (choice.row + choice.column > 0 && (choice.row >= rows || choice.column >= columns)) {
    must(Status::invalidParameter(fmt::format("there is no grid unit {},{}: this run has {} by {}",
                                              choice.row + 1, choice.column + 1, rows, columns)));
  }
}

/// What describes a unit of a ring, or of a sheet.
Json memberJson(const PopulationHistory& population, std::size_t i,
                const evaluation::MeasuredUnit& unit) {
  const auto& axes = population.info.axes;
  if (axes.size() == 1) {
    return {{"unit", i + 1},
            {"nominal_deg", axisAngle(axes[0], i) * kDegrees},
            {"preferred_deg", unit.tuning.preferred * kDegrees},
            {"tuning", unit.tuning.rate}};
  }
  const auto columns = static_cast<std::size_t>(population.shape[1]);
  const std::size_t row = i / columns, column = i % columns;
  return {{"unit", {row + 1, column + 1}},
          {"nominal", {axisValue(axes[0], row), axisValue(axes[1], column)}},
          {"fields", unit.fields}};
}

/// All measured units of all populations.
Json unitsJson(const std::vector<PopulationHistory>& populations,
               const std::vector<evaluation::PopulationFigures>& figures) {
  Json list = Json::array();
  for (std::size_t p = 0; p < populations.size(); ++p) {
    const evaluation::PopulationScores& scores = figures[p].scores;
    const std::vector<std::size_t> measured = measuredUnits(populations[p]);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      Json& json = list.emplace_back(Json{{"array", figures[p].array}});
      json.update(memberJson(populations[p], measured[i], scores.units[i]));
      for (std::size_t k = 0; k < scores.kinds.size(); ++k) {
        const auto& value = scores.units[i].scores[k];
        json[std::string(scores.kinds[k].key)] = value ? Json(*value) : Json();
      }
    }
  }
  return list;
}

}  // namespace

Result<std::vector<DrawnUnit>> drawnUnits(const RunData& run, const UnitChoice& choice) {
  return resultOf([&] {
    checkChoice(run.cells, choice);
    std::vector<DrawnUnit> units;
    const auto poses = evaluation::stampedPosesOf(run.places());
    const std::size_t size = poses.empty() ? 0 : sizeOf(run.cells.rings, 0);
    for (std::size_t turn = 0; turn < std::min<std::size_t>(size, 2); ++turn) {
      const std::size_t unit = (choice.head_direction + turn * (size / 2)) % size;
      units.push_back(headDirectionUnit(run, unit, poses));
    }
    if (!poses.empty() && !run.cells.sheets.empty()) {
      units.push_back(gridUnit(run, choice, poses));
    }
    return units;
  });
}

Json neuronsJson(const RunData& run, const std::vector<DrawnUnit>& drawn) {
  if (!run.metrics.cells) return nullptr;
  const evaluation::CellFigures& figures = *run.metrics.cells;
  Json json{{"places", figures.truth ? "truth" : "map"},
            {"head_direction", unitsJson(run.cells.rings, figures.rings)},
            {"grid", unitsJson(run.cells.sheets, figures.sheets)},
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
