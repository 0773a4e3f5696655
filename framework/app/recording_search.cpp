// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording_search.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/text_encoding.hpp"
#include "config/scalars.hpp"
#include "engine/checked_system.hpp"
#include "record/regular_file.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 40;               // files of a folder that are tried
constexpr std::chrono::seconds kLongestSearch{30};  // for pairs of folders
constexpr const char* kAssumedRate = "10";
constexpr std::array<const char*, 3> kBelow = {"", "/data", "/images"};  // in a camera's folder

/// Names in a folder, sorted; of folders, or of files with one of these suffixes.
std::vector<std::string> namesIn(const fs::path& folder, const std::vector<std::string>& suffixes) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const bool wanted = suffixes.empty()
                            ? at->is_directory(error)
                            : std::ranges::count(suffixes, at->path().extension().string()) > 0;
    if (wanted) names.push_back(at->path().filename().string());
  }
  std::ranges::sort(names);
  if (names.size() > kMaxFiles) names.resize(kMaxFiles);
  return names;
}

bool hasFiles(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored)) return true;
  }
  return false;
}

/// The folder of the right camera that belongs to one of the left; empty for none.
std::string rightOf(const std::string& left, const std::vector<std::string>& folders) {
  constexpr std::array<std::array<std::string_view, 2>, 5> kSides = {
      {{"left", "right"}, {"Left", "Right"}, {"0", "1"}, {"1", "2"}, {"a", "b"}}};
  for (const auto& [from, to] : kSides) {
    const std::size_t at = left.rfind(from);
    if (at == std::string::npos) continue;
    std::string right = left;
    right.replace(at, from.size(), to);
    if (std::ranges::count(folders, right) > 0) return right;
  }
  return "";
}

/// Path of the images of a folder, relative to its parent; empty for a folder without images.
std::string imagesOf(const fs::path& parent, const std::string& folder) {
  for (const char* below : kBelow) {
    const std::string images = folder + below;
    if (!namesIn(parent / images, {".png", ".jpg", ".jpeg"}).empty()) return images;
  }
  return "";
}

/// Puts folders with a right folder first, so that a pair is found before any single camera.
std::vector<std::string> pairsFirst(const std::vector<std::string>& folders) {
  std::vector<std::string> ordered = folders;
  std::ranges::stable_sort(
      ordered, {}, [&](const std::string& folder) { return rightOf(folder, folders).empty(); });
  return ordered;
}

/// The unit of two stamps in a row: the one in which they are times of the years 2001 to 2096 at
/// most an hour apart, otherwise the largest in which they are at most 1.5 s apart.
std::string unitOf(const std::string& first, const std::string& second) {
  constexpr std::array<std::pair<const char*, double>, 4> kUnits = {
      {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
  const double from = std::strtod(first.c_str(), nullptr);  // 0 if it is not a number
  const double step = std::strtod(second.c_str(), nullptr) - from;
  for (const auto& [unit, seconds] : kUnits) {
    const double date = from * seconds;
    if (date > 1e9 && date < 4e9 && step * seconds > 1e-4 && step * seconds < 3600) return unit;
  }
  const auto* found =
      std::ranges::find_if(kUnits, [&](const auto& unit) { return step * unit.second <= 1.5; });
  return found == kUnits.end() ? "ns" : found->first;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// A table whose first line has a column of times: its name, and the unit of the first values.
std::optional<SourceValues> timesColumn(const fs::path& file) {
  std::ifstream stream = record::openRegular(file);
  std::array<std::string, 3> lines;
  for (std::string& line : lines) {
    if (!std::getline(stream, line)) return std::nullopt;
  }
  const std::vector<std::string> names = cellsOf(lines[0]);
  const std::vector<std::string> first = cellsOf(lines[1]);
  const std::vector<std::string> second = cellsOf(lines[2]);
  for (std::size_t i = 0; i < std::min({names.size(), first.size(), second.size()}); ++i) {
    const std::string& name = names[i];
    if (name.find("time") == std::string::npos && name.find("stamp") == std::string::npos) continue;
    return SourceValues{{"stamps", config::writeText(file.filename().string())},
                        {"stamps_column", config::writeText(name)},
                        {"stamps_unit", unitOf(first[i], second[i])}};
  }
  return std::nullopt;
}

/// A file with one number a line, such as the times.txt of KITTI or of `tolman dataset import`.
std::optional<SourceValues> timesList(const fs::path& file) {
  std::ifstream stream = record::openRegular(file);
  double before = 0;
  double now = 0;
  std::string rest;
  std::string first;
  std::string second;
  if (!std::getline(stream, first) || !(std::istringstream(first) >> before)) return std::nullopt;
  if (std::istringstream(first) >> before >> rest || !std::getline(stream, second) ||
      !(std::istringstream(second) >> now)) {
    return std::nullopt;
  }
  return SourceValues{{"stamps", config::writeText(file.filename().string())},
                      {"stamps_unit", unitOf(first, second)}};
}

/// Whether the name of an image may be its time: 13 digits or more, or a number with decimals.
bool isTime(const std::string& name) {
  const std::string stem = fs::path(name).stem().string();
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto digits = std::ranges::count_if(stem, is_digit);
  const auto points = std::ranges::count(stem, '.');
  return digits + points == std::ssize(stem) && (points == 0 ? digits >= 13 : points == 1);
}

class Search {
 public:
  Search(fs::path recording, SourceValues given, const Invocation& invocation)
      : recording_(std::move(recording)), given_(std::move(given)), invocation_(invocation) {}

  RecordingSearch run() {
    tryAll({});
    std::vector<std::string> reasons = std::move(found_.reasons);  // without further parameters
    if (!found_.best) {
      tryAll({{"rate", kAssumedRate}});
      found_.rate_assumed = found_.best.has_value();
    }
    if (!found_.best) tryPairs();
    found_.reasons = std::move(reasons);
    if (!ended_.empty()) found_.reasons.push_back(ended_);
    if (found_.best && found_.best->width > 0 && !found_.best->calibrated) {
      tryCalibrations();
      if (!found_.best->calibrated) tellUnreadCalibrations();
    }
    if (found_.best && !found_.rate_assumed) tryStamps();
    if (found_.best && !found_.rate_assumed) questionRate();
    return std::move(found_);
  }

 private:
  void tryAll(const SourceValues& more) {
    SourceValues values = {{"path", config::writeText(recording_.string())}};
    values.insert(values.end(), given_.begin(), given_.end());
    values.insert(values.end(), more.begin(), more.end());
    const host::Catalogue catalogue = run::openCatalogue(invocation_.plugin_paths);
    for (const host::Manifest& manifest : catalogue.manifests()) {
      if (manifest.role == Role::Source)
        keep(manifest.id, probe(manifest.id, values, deadline_, invocation_));
    }
  }

  void keep(const std::string& plugin, Result<Probe> tried) {
    if (!tried.isOk()) {
      const Status& status = tried.status();
      if (status.code() != StatusCode::InvalidInput) return;
      found_.reasons.push_back(plugin + ": " + status.message());
      return;
    }
    const bool better = !found_.best || tried.value().rank() > found_.best->rank();
    if (better && found_.best) found_.others.push_back(found_.best->plugin);
    if (!better && found_.best->plugin != plugin) found_.others.push_back(plugin);
    if (better) found_.best = std::move(tried).value();
  }

  /// Probes the best source with further parameters.
  Result<Probe> probeWith(const SourceValues& more) {
    SourceValues values = found_.best->values;
    values.insert(values.end(), more.begin(), more.end());
    return probe(found_.best->plugin, values, deadline_, invocation_);
  }

  /// The same; none if it cannot read the recording then.
  std::optional<Probe> withMore(const SourceValues& more) {
    Result<Probe> tried = probeWith(more);
    return tried.isOk() ? std::optional(std::move(tried).value()) : std::nullopt;
  }

  /// Tests whether the stamps come from the default of `rate`: another rate changes them, and rate
  /// 0 ("as recorded") is not accepted.
  void questionRate() {
    const auto other = withMore({{"rate", "23"}});
    if (!other || std::abs(other->rate - found_.best->rate) < 0.01) return;
    if (withMore({{"rate", "0"}})) return;
    found_.best->values.emplace_back("rate", config::writeReal(std::round(found_.best->rate)));
    found_.rate_assumed = true;
  }

  void tryPairs() {
    const auto end = std::chrono::steady_clock::now() + kLongestSearch;
    const std::vector<std::string> folders = namesIn(recording_, {});
    for (const std::string& left : pairsFirst(folders)) {
      const std::string right = rightOf(left, folders);
      for (const std::string below : kBelow) {
        if (!hasFiles(recording_ / (left + below))) continue;
        SourceValues values = {{"left", config::writeText(left + below)}};
        if (!right.empty()) values.emplace_back("right", config::writeText(right + below));
        if (!found_.best) tryAll(values);
        // Raw images are accepted as a pair only with their calibration.
        values.emplace_back("calibration", "");
        for (const std::string& file : calibrations()) {
          values.back().second = config::writeText(file);
          if (found_.best) break;
          if (std::chrono::steady_clock::now() > end) return endSearch(left + below);
          tryAll(values);
        }
        if (!found_.best && std::chrono::steady_clock::now() > end) return endSearch(left + below);
      }
    }
    if (found_.best) tellOtherFolders(folders);
  }

  void endSearch(const std::string& folder) {
    ended_ = "search for folders of images: ended after " + std::to_string(kLongestSearch.count()) +
             " s, at '" + folder +
             "'; name the folder of one recording, or its images: --set left=FOLDER";
  }

  void tellOtherFolders(const std::vector<std::string>& folders) {
    for (const std::string& folder : folders) {
      const std::string images = imagesOf(recording_, folder);
      const auto reads = [&](const auto& value) {
        return value.second == config::writeText(images) &&
               (value.first == "left" || value.first == "right");
      };
      if (images.empty() || std::ranges::any_of(found_.best->values, reads)) continue;
      found_.other_folders.push_back(images);
    }
  }

  std::vector<std::string> calibrations() const {
    return namesIn(recording_, {".yaml", ".yml", ".xml", ".txt"});
  }

  void tryCalibrations() {
    for (const std::string& file : calibrations()) {
      auto calibrated = withMore({{"calibration", config::writeText(file)}});
      if (!calibrated || !calibrated->calibrated) continue;
      found_.best = std::move(calibrated);
      return;
    }
  }

  /// Keeps the reasons of sources that name a line of a file that seems to be a calibration.
  void tellUnreadCalibrations() {
    for (const std::string& file : calibrations()) {
      std::string name = file;
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
      constexpr std::array kWords = {"calib", "cam", "intrinsic", "sensor"};
      const bool is_calibration = std::ranges::any_of(
          kWords, [&](const char* word) { return name.find(word) != std::string::npos; });
      const std::string path = (recording_ / file).string() + ":";
      for (const std::string& reason : found_.reasons) {
        const std::size_t at = reason.find(path);
        if (!is_calibration || at == std::string::npos) continue;
        found_.unread_calibrations.push_back(reason.substr(at));
        break;  // further sources say the same
      }
    }
  }

  void tryStamps() {
    for (const std::string& file : namesIn(recording_, {".csv", ".txt"})) {
      const std::string problem = text_encoding::encodingProblemOf(recording_ / file);
      if (!problem.empty()) {
        found_.unread_times.push_back((recording_ / file).string() + ": " + problem);
        continue;
      }
      const bool is_table = fs::path(file).extension() == ".csv";
      const auto column = is_table ? timesColumn(recording_ / file) : timesList(recording_ / file);
      if (column && tryTimes(*column)) return;
    }
    fs::path images = recording_;
    for (const auto& [name, value] : found_.best->values) {
      if (name == "left") images = recording_ / value;
    }
    const auto names = namesIn(images, {".png", ".jpg", ".jpeg"});
    if (names.size() < 2 || !isTime(names[0]) || !isTime(names[1])) return;
    const std::string unit =
        unitOf(fs::path(names[0]).stem().string(), fs::path(names[1]).stem().string());
    tryTimes({{"stamps_in_names", "true"}, {"stamps_unit", unit}});
  }

  /// Whether the best source can read these times; otherwise keeps its reason.
  bool tryTimes(const SourceValues& times) {
    Result<Probe> tried = probeWith(times);
    if (tried.isOk()) {
      found_.best = std::move(tried).value();
      return true;
    }
    if (tried.status().code() == StatusCode::InvalidInput) {
      std::string reason = tried.status().message();
      std::ranges::replace(reason, '\n', ' ');
      found_.unread_times.push_back(std::move(reason));
    }
    return false;
  }

  fs::path recording_;
  SourceValues given_;
  const Invocation& invocation_;
  std::chrono::seconds deadline_ = probeDeadline(recording_);
  RecordingSearch found_;
  std::string ended_;  ///< why not all folders were tried
};

}  // namespace

RecordingSearch searchRecording(const fs::path& recording, const SourceValues& given,
                                const Invocation& invocation) {
  return Search(recording, given, invocation).run();
}

}  // namespace tolman::app
