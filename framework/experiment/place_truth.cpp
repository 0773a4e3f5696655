// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/place_truth.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/bounded_json.hpp"
#include "base/open_files.hpp"
#include "base/text_encoding.hpp"
#include "evaluation/loops.hpp"
#include "report/axes.hpp"

namespace tolman::experiment {

namespace {

using Pair = std::pair<std::int64_t, std::int64_t>;

std::optional<Pair> pairOf(const std::string& line) {
  const char* const end = line.data() + line.size();
  Pair pair;
  const auto first = std::from_chars(line.data(), end, pair.first);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != ',') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, pair.second);
  const bool complete = second.ptr == end || *second.ptr == '\r';
  if (second.ec != std::errc() || !complete) return std::nullopt;
  if (pair.first < 0 || pair.second < 0) return std::nullopt;
  return pair;
}

bool isHeader(std::string line) {
  std::erase_if(line, [](char c) { return c == ' ' || c == '\r' || c == '"'; });
  return line == "query,match";
}

}  // namespace

PlaceTruth truthByNumber(std::int64_t images_of_first_pass, std::int64_t tolerance) {
  return {
      [=](std::int64_t query, std::int64_t place) { return std::abs(query - place) <= tolerance; },
      [=](std::int64_t query) { return query < images_of_first_pass + tolerance; }, -1};
}

Result<PlaceTruth> truthOfPairs(const std::filesystem::path& file, std::int64_t near) {
  std::error_code ignored;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, ignored)) stream.open(file);  // a pipe would block
  if (!stream.is_open()) {
    return Status::invalidInput(file.string() + ": " +
                                file_opening::notOpened("cannot be read as a file of true pairs"));
  }
  if (const std::string problem = text_encoding::encodingProblemOf(file); !problem.empty()) {
    return Status::invalidInput(file.string() + ": " + problem);
  }
  auto pairs = std::make_shared<std::set<Pair>>();
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (number == 1) line = text_encoding::withoutMark(line);
    if (number == 1 && isHeader(line)) continue;
    const auto pair = pairOf(line);
    const std::string where = file.string() + ":" + std::to_string(number) + ": ";
    if (!pair) {
      return Status::invalidInput(where + "a pair is two numbers of images, 'query,match'");
    }
    if (pair->second >= pair->first) {
      return Status::invalidInput(where + "the match must be an earlier image than the query");
    }
    pairs->insert(*pair);
  }
  if (pairs->empty()) {
    return Status::invalidInput(file.string() + ": lists no pairs; each line is 'query,match'");
  }
  return PlaceTruth{[pairs](std::int64_t query, std::int64_t place) {
                      return pairs->contains({query, place});
                    },
                    [pairs, near](std::int64_t query) {
                      const auto earliest = pairs->lower_bound({query, INT64_MIN});
                      return earliest != pairs->end() && earliest->first == query &&
                             query - earliest->second > near;
                    },
                    pairs->rbegin()->first};
}

PlaceTruth truthOfPoses(const evaluation::Trajectory& truth, double height_m, std::int64_t near) {
  evaluation::RevisitRule rule;
  rule.height_m = height_m;
  auto findable = std::make_shared<std::set<std::int64_t>>();
  for (const evaluation::Revisit& revisit : evaluation::findRevisits(truth, rule)) {
    if (revisit.heading == evaluation::Heading::Same) findable->insert(revisit.frame);
  }
  auto poses = std::make_shared<evaluation::Trajectory>(truth);
  auto path = std::make_shared<std::vector<double>>(evaluation::distances(truth));
  const auto isSame = [poses, path, rule](std::int64_t query, std::int64_t place) {
    const double between =
        (*path)[static_cast<std::size_t>(query)] - (*path)[static_cast<std::size_t>(place)];
    if (between <= rule.path_m) return false;
    const auto& q = (*poses)[static_cast<std::size_t>(query)].T_world_camera;
    const auto& p = (*poses)[static_cast<std::size_t>(place)].T_world_camera;
    return evaluation::isSamePlace(q, p, rule) &&
           evaluation::headingBetween(q, p, rule) == evaluation::Heading::Same;
  };
  const auto isFindable = [findable, isSame, near](std::int64_t query) {
    if (!findable->contains(query)) return false;
    for (std::int64_t place = 0; place < query - near; ++place) {
      if (isSame(query, place)) return true;
    }
    return false;
  };
  return {isSame, isFindable};
}

namespace {

std::optional<double> shareIn(const nlohmann::json& point, const char* key) {
  if (!point.is_object() || !point.contains(key) || !point[key].is_number()) return std::nullopt;
  const double share = point[key].get<double>();
  if (!(share >= 0 && share <= 1)) return std::nullopt;
  return share;
}

std::optional<PlaceCurve> curveIn(const nlohmann::json& measured) {
  const auto has = [&](const char* key) { return measured.contains(key); };
  if (!measured.is_object() || !has("name") || !has("curve")) return std::nullopt;
  if (!measured["name"].is_string() || !measured["curve"].is_array()) return std::nullopt;
  PlaceCurve curve{measured["name"].get<std::string>(), {}};
  for (const nlohmann::json& point : measured["curve"]) {
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
  const nlohmann::json measured = bounded_json::parse<nlohmann::json>(stream);
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

}  // namespace tolman::experiment
