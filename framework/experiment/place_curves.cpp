// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/place_curves.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/bounded_json.hpp"
#include "base/open_files.hpp"
#include "base/text_encoding.hpp"
#include "report/axes.hpp"

namespace tolman::bench {
namespace {

using nlohmann::json;

std::optional<double> shareIn(const json& point, const char* key) {
  if (!point.is_object() || !point.contains(key) || !point[key].is_number()) return std::nullopt;
  const double share = point[key].get<double>();
  if (!(share >= 0 && share <= 1)) return std::nullopt;
  return share;
}

std::optional<PlaceCurve> curveIn(const json& measured) {
  const auto has = [&](const char* key) { return measured.contains(key); };
  if (!measured.is_object() || !has("name") || !has("curve")) return std::nullopt;
  if (!measured["name"].is_string() || !measured["curve"].is_array()) return std::nullopt;
  PlaceCurve curve{measured["name"].get<std::string>(), {}};
  for (const json& point : measured["curve"]) {
    const auto precision = shareIn(point, "precision");
    const auto recall = shareIn(point, "recall");
    if (!precision || !recall) return std::nullopt;
    curve.points.push_back({0, 0, *precision, *recall});
  }
  return curve;
}

}  // namespace

Result<PlaceCurve> placeCurveOf(const std::filesystem::path& file) {
  std::error_code ignored;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, ignored)) stream.open(file);  // a pipe would block
  if (!stream.is_open())
    return Status::invalidInput(file.string() + ": " + file_opening::notOpened("cannot be read"));
  if (const std::string problem = text_encoding::encodingProblemOf(file); !problem.empty()) {
    return Status::invalidInput(file.string() + ": " + problem);
  }
  const json measured = bounded_json::parse<json>(stream);
  const auto curve = measured.is_discarded() ? std::nullopt : curveIn(measured);
  if (!curve) {
    return Status::invalidInput(file.string() +
                                ": is not what `tolman bench places --json` prints");
  }
  return *curve;
}

std::string placeCurvesFigure(const std::vector<PlaceCurve>& curves) {
  constexpr std::array kColours = {report::kBlue,   report::kVermilion, report::kGreen,
                                   report::kOrange, report::kPurple,    report::kGrey};
  report::Svg svg(560, 460);
  report::Axes axes(svg, {"Places recognised",
                          "recall",
                          "precision",
                          {0, 1},
                          {0, 1.03},
                          report::frame(70, 60, 540, 410)});
  std::vector<report::Axes::LegendEntry> names;
  for (const PlaceCurve& curve : curves) {
    const char* colour = kColours[names.size() % kColours.size()];
    names.push_back({colour, curve.name});
    std::vector<double> recall;
    std::vector<double> precision;
    for (const auto& point : curve.points) {
      recall.push_back(point.recall);
      precision.push_back(point.precision);
    }
    axes.polyline(recall, precision, colour, 2);
  }
  axes.legend(names);
  return svg.take();
}

}  // namespace tolman::bench
