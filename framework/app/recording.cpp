// SPDX-License-Identifier: BSD-3-Clause
// Which source reads a recording, and with which parameters.
#include "app/recording.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "app/kitti_folder.hpp"
#include "app/options.hpp"
#include "base/text_file.hpp"
#include "config/loader.hpp"
#include "config/text.hpp"
#include "engine/checked_system.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using text_encoding::parseNumber;
using Names = std::vector<std::string>;

constexpr std::size_t kMaxFiles = 40;  // of a folder that are tried
constexpr int kProbedFrames = 10;
constexpr const char* kAssumedRate = "10";
const Names kImageEndings = {".png", ".jpg", ".jpeg"};

/// Names in a folder, sorted; of folders, or of files with one of these endings.
Names namesIn(const fs::path& folder, const Names& endings) {
  Names names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    const bool wanted = endings.empty()
                            ? at->is_directory(ignored)
                            : std::ranges::count(endings, at->path().extension().string()) > 0;
    if (wanted) names.push_back(at->path().filename().string());
  }
  std::ranges::sort(names);
  if (names.size() > kMaxFiles) names.resize(kMaxFiles);
  return names;
}

bool fits(const std::string& pattern, const std::string& name) {
  return ::fnmatch(pattern.c_str(), name.c_str(), FNM_CASEFOLD) == 0;
}

/// The folder of the right camera that belongs to one of the left; empty for none.
std::string rightOf(const std::string& left, const Names& folders) {
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

/// The unit of two stamps in a row: the one in which they are times of the years 2001 to 2096 at
/// most an hour apart, otherwise the largest in which they are at most 1.5 s apart.
std::string unitOf(double first, double second) {
  constexpr std::array<std::pair<const char*, double>, 4> kUnits = {
      {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
  const double step = second - first;
  for (const auto& [unit, seconds] : kUnits) {
    const double date = first * seconds;
    if (date > 1e9 && date < 4e9 && step * seconds > 1e-4 && step * seconds < 3600) return unit;
  }
  const auto* found =
      std::ranges::find_if(kUnits, [&](const auto& unit) { return step * unit.second <= 1.5; });
  return found == kUnits.end() ? "ns" : found->first;
}

Names cellsOf(const std::string& line) {
  Names cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    cell.erase(cell.find_last_not_of(" \r") + 1);
    cells.push_back(cell);
  }
  return cells;
}

/// How a source reads the times in this file: a table whose first line has a column of times, or
/// one number a line. Empty for another file.
SourceValues timesIn(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<Names, 3> lines;
  for (Names& cells : lines) {
    std::string line;
    if (!std::getline(stream, line)) return {};
    cells = cellsOf(line);
  }
  const auto& [names, first, second] = lines;
  const SourceValues values = {{"stamps", config::writeText(file.filename().string())}};
  // NUMBER TIME EXPOSURE, as TUM's monocular sets have it: seconds.
  std::istringstream exposed(names.empty() ? "" : names[0]);
  if (double number = 0, time = 0, ms = 0; exposed >> number >> time >> ms) return values;
  for (std::size_t i = 0; i < std::min({names.size(), first.size(), second.size()}); ++i) {
    const bool is_list = i == 0 && names.size() == 1 && parseNumber(names[0]);
    const bool is_column = fits("*time*", names[i]) || fits("*stamp*", names[i]);
    const auto from = parseNumber(is_list ? names[0] : first[i]);
    const auto to = parseNumber(is_list ? first[0] : second[i]);
    if (!(is_list || is_column) || !from || !to) continue;
    SourceValues found = values;
    if (!is_list) found.emplace_back("stamps_column", config::writeText(names[i]));
    found.emplace_back("stamps_unit", unitOf(*from, *to));
    return found;
  }
  return {};
}

/// How a source reads the names of the images as their times: numbers of 13 digits or more, or with
/// decimals. Empty for other names.
SourceValues timesInNames(const fs::path& folder) {
  std::vector<double> times;
  for (const std::string& name : namesIn(folder, kImageEndings)) {
    const std::string stem = fs::path(name).stem();
    const auto digits = std::ranges::count_if(stem, config::isDigit);
    const auto points = std::ranges::count(stem, '.');
    const bool is_time = points == 0 ? digits >= 13 : points == 1;
    if (!is_time || digits + points != std::ssize(stem)) return {};
    times.push_back(parseNumber(stem).value_or(0));
  }
  if (times.size() < 2) return {};
  std::ranges::sort(times);
  return {{"stamps_in_names", "true"}, {"stamps_unit", unitOf(times[0], times[1])}};
}

/// One source on one recording, with more and more parameters.
class Search {
 public:
  Search(const fs::path& path, const host::LoadedPlugin& plugin, SourceValues given,
         const Invocation& invocation)
      : path_(path), plugin_(plugin), given_(std::move(given)), invocation_(invocation) {
    given_.insert(given_.begin(), {"path", config::writeText(path.string())});
  }

  /// The first way of reading it that works, with calibration and times if they are found.
  Result<Recording> run() {
    std::vector<SourceValues> ways = withTimesInNames({});
    if (may("rate")) ways.push_back({{"rate", kAssumedRate}});
    Status reason = takeFirst(ways);
    if (!reason.isOk() && may("left") && may("right") && takeFirst(folderWays()).isOk()) {
      reason = Status::ok();
    }
    if (!reason.isOk()) return reason;
    if (best_.width > 0 && !best_.calibrated && may("calibration")) tryCalibrations();
    const bool has_response = std::ranges::count(calibrations(), "pcalib.txt") > 0;
    if (has_response && may("response")) take({{"response", "pcalib.txt"}}, "pcalib.txt");
    const bool has_times = best_.isGiven("rate") || best_.isGiven("stamps_in_names");
    if (!has_times && may("stamps")) tryStamps();
    noteRate();
    return best_;
  }

 private:
  const ParameterInfo* declared(std::string_view name) const {
    const auto found = std::ranges::find(plugin_.schema, name, &ParameterInfo::name);
    return found == plugin_.schema.end() ? nullptr : &*found;
  }

  /// Whether the source has this parameter, and the user does not give it.
  bool may(std::string_view name) const {
    return declared(name) != nullptr && std::ranges::find(given_, name, nameOf) == given_.end();
  }
  static const std::string& nameOf(const SourceValues::value_type& value) { return value.first; }

  /// The folder of the left images, if it is known.
  fs::path imageFolder(const SourceValues& values) const {
    for (const auto* known : {&values, &given_}) {
      const auto left = std::ranges::find(*known, "left", nameOf);
      if (left != known->end()) return path_ / left->second;
    }
    return path_;
  }

  /// These parameters, and the same with the names of the images as times: names with decimals of
  /// different lengths have no other order.
  std::vector<SourceValues> withTimesInNames(const SourceValues& way) const {
    std::vector<SourceValues> ways = {way};
    SourceValues times;
    if (may("stamps_in_names")) times = timesInNames(imageFolder(way));
    if (times.empty()) return ways;
    ways.push_back(way);
    ways.back().insert(ways.back().end(), times.begin(), times.end());
    return ways;
  }

  /// The first of these that the source reads; else why it does not read the very first.
  Status takeFirst(const std::vector<SourceValues>& ways) {
    Status reason = Status::invalidInput("no folder of images is read");
    for (const SourceValues& way : ways) {
      Result<Recording> found = probe(way);
      if (found.isOk()) {
        best_ = std::move(found).value();
        for (const std::string& folder : folders_) {
          const auto reads = [&](const auto& v) { return v.second == config::writeText(folder); };
          if (std::ranges::none_of(best_.values, reads)) best_.other_folders.push_back(folder);
        }
        return Status::ok();
      }
      if (&way == &ways.front()) reason = found.status();
    }
    return reason;
  }

  /// Reads the first frames as a run would, with these parameters beside the given ones.
  Result<Recording> probe(const SourceValues& more) const try {
    SourceValues values = given_;
    values.insert(values.end(), more.begin(), more.end());
    engine::SystemOptions options{
        "", {"source.plugin=" + plugin_.manifest.id}, invocation_.plugin_paths};
    for (const auto& [name, value] : values) {
      options.overrides.push_back("source." + name + "=" + value);
    }
    engine::RunLog log(true);
    const engine::SteadyClock clock;
    const Never never;
    engine::Assembly assembly(engine::checkSystem(options, engine::Scope::Source), log, clock,
                              never);
    std::vector<std::int64_t> stamps_ns;
    while (stamps_ns.size() < kProbedFrames) {
      Frame frame;
      const Status status = assembly.source().next(frame);
      if (status.code() == StatusCode::EndOfStream) break;
      engine::require(status, engine::FailureKind::Dataset);
      stamps_ns.push_back(frame.stamp_ns);
    }
    if (stamps_ns.empty()) return Status::invalidInput("there is no frame");
    const SourceInfo& info = assembly.sourceInfo();
    std::vector<ArrayInfo> arrays;
    (void)assembly.source().instance().describe(arrays);  // it has given frames
    Recording found{plugin_.manifest.id, values,          info.description,
                    info.rig.width,      info.rig.height, info.rig.calibrated,
                    info.rig.baseline};
    found.depth = !depthArray(arrays).empty();
    found.has_truth = info.has_truth;
    const double seconds = 1e-9 * static_cast<double>(stamps_ns.back() - stamps_ns.front());
    if (seconds > 0) found.rate = static_cast<double>(stamps_ns.size() - 1) / seconds;
    found.warnings = log.keptWarnings();
    for (const std::string& doubt : assembly.source().doubts()) {
      found.warnings.push_back("source: " + doubt);
    }
    return found;
  } catch (const engine::Failure& failed) {
    using Kind = engine::FailureKind;
    const Kind kind = failed.kind;
    if (kind == Kind::Machine || kind == Kind::Record || kind == Kind::Interrupted) throw;
    const std::string prefix = "source (" + plugin_.manifest.id + "), configure: ";
    const std::string text = failed.what();
    return Status::invalidInput(text.starts_with(prefix) ? text.substr(prefix.size()) : text);
  }

  /// With folders of images below the recording: pairs with each calibration, then one camera.
  std::vector<SourceValues> folderWays() {
    const Names all = namesIn(path_, {});
    std::map<std::string, std::string> images;  // by folder
    for (const std::string& folder : all) {
      for (const char* below : {"/images", "/data", ""}) {
        if (namesIn(path_ / (folder + below), kImageEndings).empty()) continue;
        images[folder] = folder + below;
      }
    }
    std::vector<SourceValues> ways;
    for (const auto& [left, place] : images) {
      folders_.push_back(place);
      const auto right = images.find(rightOf(left, all));
      if (right == images.end()) continue;
      for (const std::string& file : calibrations()) {
        ways.push_back({{"left", config::writeText(place)},
                        {"right", config::writeText(right->second)},
                        {"calibration", config::writeText(file)}});
      }
    }
    for (const std::string& place : folders_) ways.push_back({{"left", config::writeText(place)}});
    std::vector<SourceValues> with_times;
    for (const SourceValues& way : ways) {
      std::ranges::move(withTimesInNames(way), std::back_inserter(with_times));
    }
    return with_times;
  }

  Names calibrations() const { return namesIn(path_, {".yaml", ".yml", ".xml", ".txt"}); }

  /// Takes the result with these parameters if the source reads it; otherwise keeps the reason
  /// under this name, if there is one.
  bool take(const SourceValues& more, const std::string& name) {
    SourceValues all(best_.values.begin() + std::ssize(given_), best_.values.end());
    all.insert(all.end(), more.begin(), more.end());
    const Result<Recording> tried = probe(all);
    if (!tried.isOk()) {
      std::string reason = name + ": " + tried.status().message();
      std::ranges::replace(reason, '\n', ' ');
      if (!name.empty()) best_.unused.push_back(std::move(reason));
      return false;
    }
    if (more[0].first == "calibration" && !tried.value().calibrated) return false;
    Recording found = tried.value();
    found.other_folders = best_.other_folders;
    found.unused = best_.unused;
    best_ = std::move(found);
    return true;
  }

  void tryCalibrations() {
    constexpr std::array kPatterns = {"*calib*", "*cam*", "*intrinsic*", "*sensor*"};
    for (const std::string& file : calibrations()) {
      const bool is_calibration =
          std::ranges::any_of(kPatterns, [&](const char* pattern) { return fits(pattern, file); });
      if (take({{"calibration", config::writeText(file)}}, is_calibration ? file : "")) return;
    }
  }

  void tryStamps() {
    for (const std::string& file : namesIn(path_, {".csv", ".txt"})) {
      const SourceValues times = timesIn(path_ / file);
      if (!times.empty() && take(times, file)) return;
    }
    const SourceValues times = timesInNames(imageFolder(best_.values));
    if (!times.empty()) take(times, "the names of the images");
  }

  /// Whether the rate is the one that was tried, or the default of the source.
  void noteRate() {
    if (!may("rate")) return;
    best_.rate_assumed = best_.isGiven("rate");
    if (best_.rate_assumed || best_.isGiven("stamps") || best_.isGiven("stamps_in_names")) return;
    const double assumed = std::get<double>(declared("rate")->default_value);
    if (assumed <= 0 || std::abs(best_.rate - assumed) > 0.01) return;
    best_.values.emplace_back("rate", config::writeReal(assumed));
    best_.rate_assumed = true;
  }

  struct Never : Cancellation {
    bool requested() const override { return false; }
  };

  const fs::path& path_;
  const host::LoadedPlugin& plugin_;
  SourceValues given_;
  const Invocation& invocation_;
  Names folders_;  ///< with images, below the recording
  Recording best_;
};

}  // namespace

bool Recording::isGiven(std::string_view parameter) const {
  return std::ranges::any_of(values, [&](const auto& value) { return value.first == parameter; });
}

std::string sourceFor(const fs::path& recording) {
  Names names = {recording.filename().string()};
  std::error_code error;
  for (fs::directory_iterator at(recording, error), end; !error && at != end; at.increment(error)) {
    names.push_back(at->path().filename().string());
  }
  const auto isMet = [&](const config::Node& line) {  // all patterns by names of the recording
    std::istringstream patterns(line.text);
    for (std::string pattern; patterns >> pattern;) {
      const auto isOf = [&](const std::string& name) { return fits(pattern, name); };
      if (std::ranges::none_of(names, isOf)) return false;
    }
    return true;
  };
  const config::Loaded layouts =
      config::load(configFile("configs/init/layouts.yaml"), {}, config::processEnvironment());
  for (const config::Node& source : layouts.tree.children) {
    if (std::ranges::any_of(source.children, isMet)) return source.key;
  }
  return "";
}

Recording lookAt(const fs::path& recording, const SourceValues& given,
                 const Invocation& invocation) {
  std::string id = sourceFor(recording);
  if (id.empty()) id = "images";
  SourceValues values;
  for (const auto& value : given) {
    if (value.first == "plugin") {
      id = value.second;
    } else {
      values.push_back(value);
    }
  }
  const host::LoadedPlugin plugin =
      engine::loadFrom(engine::openCatalogue(invocation.plugin_paths), id, Role::Source);
  Result<Recording> found = Search(recording, plugin, values, invocation).run();
  if (found.isOk()) return std::move(found).value();
  fail(ExitCode::Dataset, recording.string() + ": no source reads it\n  " + id + ": " +
                              found.status().message() +
                              "\nThe source is chosen by --set plugin=ID, its parameters by --set "
                              "NAME=VALUE; see docs/your-camera.md");
}

}  // namespace tolman::app
