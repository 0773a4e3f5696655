// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording_search.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include "config/scalars.hpp"
#include "run/checked_system.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 40;  // files of a folder that are tried
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

std::string unitOf(const std::string& stamp) {
  const double value = std::strtod(stamp.c_str(), nullptr);  // 0 if it is not a number
  return value > 1e17 ? "ns" : value > 1e14 ? "us" : value > 1e11 ? "ms" : "s";
}

/// A table whose first line has a column of times: its name, and the unit of the first value.
std::optional<SourceValues> timesColumn(const fs::path& file) {
  std::ifstream stream(file);
  std::string header;
  std::string first;
  if (!std::getline(stream, header) || !std::getline(stream, first)) return std::nullopt;
  std::istringstream names(header);
  std::istringstream cells(first);
  std::string name;
  std::string cell;
  while (std::getline(names, name, ',') && std::getline(cells, cell, ',')) {
    if (name.find("time") == std::string::npos && name.find("stamp") == std::string::npos) continue;
    return SourceValues{{"stamps", config::writeText(file.filename().string())},
                        {"stamps_column", config::writeText(name)},
                        {"stamps_unit", unitOf(cell)}};
  }
  return std::nullopt;
}

/// A file with one number a line, such as the times.txt of KITTI or of `tolman dataset import`.
std::optional<SourceValues> timesList(const fs::path& file) {
  std::ifstream stream(file);
  double before = 0;
  double now = 0;
  std::string rest;
  std::string first;
  if (!std::getline(stream, first) || !(std::istringstream(first) >> before)) return std::nullopt;
  if (std::istringstream(first) >> before >> rest || !(stream >> now) || now <= before) {
    return std::nullopt;
  }
  return SourceValues{{"stamps", config::writeText(file.filename().string())},
                      {"stamps_unit", unitOf(first)}};
}

bool isLongNumber(const std::string& name) {
  const std::string stem = fs::path(name).stem().string();
  return stem.size() >= 13 &&
         std::ranges::all_of(stem, [](unsigned char c) { return std::isdigit(c) != 0; });
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
    if (found_.best && found_.best->width > 0 && !found_.best->calibrated) tryCalibrations();
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

  /// Probes the best source with further parameters; none if it cannot read the recording then.
  std::optional<Probe> withMore(const SourceValues& more) {
    SourceValues values = found_.best->values;
    values.insert(values.end(), more.begin(), more.end());
    Result<Probe> tried = probe(found_.best->plugin, values, deadline_, invocation_);
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
    const std::vector<std::string> folders = namesIn(recording_, {});
    for (const std::string& left : pairsFirst(folders)) {
      const std::string right = rightOf(left, folders);
      for (const std::string below : kBelow) {
        SourceValues values = {{"left", config::writeText(left + below)}};
        if (!right.empty()) values.emplace_back("right", config::writeText(right + below));
        if (!found_.best) tryAll(values);
        // Raw images are accepted as a pair only with their calibration.
        values.emplace_back("calibration", "");
        for (const std::string& file : calibrations()) {
          values.back().second = config::writeText(file);
          if (!found_.best) tryAll(values);
        }
      }
    }
    if (found_.best) tellOtherFolders(folders);
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

  void tryStamps() {
    for (const std::string& file : namesIn(recording_, {".csv", ".txt"})) {
      const bool is_table = fs::path(file).extension() == ".csv";
      const auto column = is_table ? timesColumn(recording_ / file) : timesList(recording_ / file);
      auto stamped = column ? withMore(*column) : std::nullopt;
      if (!stamped) continue;
      found_.best = std::move(stamped);
      return;
    }
    fs::path images = recording_;
    for (const auto& [name, value] : found_.best->values) {
      if (name == "left") images = recording_ / value;
    }
    const auto names = namesIn(images, {".png", ".jpg", ".jpeg"});
    if (names.empty() || !isLongNumber(names.front())) return;
    const std::string unit = unitOf(fs::path(names.front()).stem().string());
    auto stamped = withMore({{"stamps_in_names", "true"}, {"stamps_unit", unit}});
    if (stamped) found_.best = std::move(stamped);
  }

  fs::path recording_;
  SourceValues given_;
  const Invocation& invocation_;
  std::chrono::seconds deadline_ = probeDeadline(recording_);
  RecordingSearch found_;
};

}  // namespace

RecordingSearch searchRecording(const fs::path& recording, const SourceValues& given,
                                const Invocation& invocation) {
  return Search(recording, given, invocation).run();
}

}  // namespace tolman::app
