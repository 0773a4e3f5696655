// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "app/options.hpp"
#include "app/rendering.hpp"
#include "config/loader.hpp"
#include "config/text.hpp"
#include "engine/assembly.hpp"
#include "host/gate.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
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

/// Whether all patterns of a line are met by names of the recording.
bool isMet(const std::string& line, const Names& names) {
  std::istringstream patterns(line);
  for (std::string pattern; patterns >> pattern;) {
    const auto fits = [&](const std::string& name) {
      return ::fnmatch(pattern.c_str(), name.c_str(), FNM_CASEFOLD) == 0;
    };
    if (std::ranges::none_of(names, fits)) return false;
  }
  return true;
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

Names cellsOf(const std::string& line) {
  Names cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

bool isNumber(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && text.find_first_not_of(" \r", end - text.c_str()) == std::string::npos;
}

/// How a source reads the times in this file: a table whose first line has a column of times, or
/// one number a line. Empty for another file.
SourceValues timesIn(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<std::string, 3> lines;
  for (std::string& line : lines) {
    if (!std::getline(stream, line)) return {};
  }
  SourceValues values = {{"stamps", config::writeText(file.filename().string())}};
  if (isNumber(lines[0]) && isNumber(lines[1])) {
    values.emplace_back("stamps_unit", unitOf(lines[0], lines[1]));
    return values;
  }
  const Names names = cellsOf(lines[0]);
  const Names first = cellsOf(lines[1]);
  const Names second = cellsOf(lines[2]);
  for (std::size_t i = 0; i < std::min({names.size(), first.size(), second.size()}); ++i) {
    const std::string& name = names[i];
    if (name.find("time") == std::string::npos && name.find("stamp") == std::string::npos) continue;
    values.emplace_back("stamps_column", config::writeText(name));
    values.emplace_back("stamps_unit", unitOf(first[i], second[i]));
    return values;
  }
  return {};
}

/// Whether the name of an image may be its time: 13 digits or more, or a number with decimals.
bool isTime(const std::string& stem) {
  const auto digits = std::ranges::count_if(stem, config::isDigit);
  const auto points = std::ranges::count(stem, '.');
  return digits + points == std::ssize(stem) && (points == 0 ? digits >= 13 : points == 1);
}

/// One source on one recording, with more and more parameters.
class Search {
 public:
  Search(const fs::path& path, const host::LoadedPlugin& plugin, SourceValues given,
         const Invocation& invocation)
      : path_(path), plugin_(plugin), given_(std::move(given)), invocation_(invocation) {
    given_.insert(given_.begin(), {"path", config::writeText(path.string())});
  }

  const ParameterInfo* declared(std::string_view name) const {
    const auto found = std::ranges::find(plugin_.schema, name, &ParameterInfo::name);
    return found == plugin_.schema.end() ? nullptr : &*found;
  }

  Result<Recording> run() {
    Result<Recording> found = probe(given_);
    if (!found.isOk() && may("rate")) {
      if (auto tried = probe(with(given_, {{"rate", kAssumedRate}})); tried.isOk()) found = tried;
    }
    if (!found.isOk() && may("left") && may("right")) {
      if (auto tried = withFolders(); tried.isOk()) found = tried;
    }
    if (!found.isOk()) return found;
    best_ = std::move(found).value();
    if (best_.width > 0 && !best_.calibrated && may("calibration")) tryCalibrations();
    if (!best_.isGiven("rate") && may("stamps")) tryStamps();
    noteRate();
    return best_;
  }

 private:
  static SourceValues with(SourceValues values, const SourceValues& more) {
    values.insert(values.end(), more.begin(), more.end());
    return values;
  }

  /// Whether the source has this parameter, and the user does not give it.
  bool may(std::string_view name) const {
    return declared(name) != nullptr && std::ranges::find(given_, name, [](const auto& value) {
                                          return std::string_view(value.first);
                                        }) == given_.end();
  }

  /// Reads the first frames as a run would.
  Result<Recording> probe(const SourceValues& values) const try {
    engine::SystemOptions options{
        "", {"source.plugin=" + plugin_.manifest.id}, invocation_.plugin_paths};
    for (const auto& [name, value] : values) {
      options.overrides.push_back("source." + name + "=" + value);
    }
    engine::RunLog log(true);
    const engine::SteadyClock clock;
    engine::Assembly assembly(engine::require(engine::checkSystem(options, engine::Scope::Source)),
                              log, clock, never_);
    std::vector<std::int64_t> stamps_ns;
    while (stamps_ns.size() < kProbedFrames) {
      Frame frame;
      const Status status = assembly.source().next(frame);
      if (status.code() == StatusCode::EndOfStream) break;
      engine::require(status, engine::FailureKind::Dataset);
      stamps_ns.push_back(frame.stamp_ns);
    }
    if (stamps_ns.empty()) return Status::invalidInput("there is no frame");
    return describe(assembly, log, values, stamps_ns);
  } catch (const engine::Failed& failed) {
    using Kind = engine::FailureKind;
    const Kind kind = failed.failure.kind;
    if (kind == Kind::Machine || kind == Kind::Record || kind == Kind::Interrupted) throw;
    const std::string prefix = "source (" + plugin_.manifest.id + "), configure: ";
    const std::string text = failed.what();
    return Status::invalidInput(text.starts_with(prefix) ? text.substr(prefix.size()) : text);
  }

  Recording describe(engine::Assembly& assembly, const engine::RunLog& log,
                     const SourceValues& values, const std::vector<std::int64_t>& stamps_ns) const {
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
  }

  /// With folders of images below the recording: a pair with its calibration before one camera.
  Result<Recording> withFolders() const {
    const Names all = namesIn(path_, {});
    std::map<std::string, std::string> images;  // by folder
    for (const std::string& folder : all) {
      for (const char* below : {"", "/data", "/images"}) {
        if (images.contains(folder)) break;
        if (!namesIn(path_ / (folder + below), kImageEndings).empty()) {
          images[folder] = folder + below;
        }
      }
    }
    const auto noteOthers = [&](Recording found) {
      for (const auto& [folder, place] : images) {
        const auto reads = [&](const auto& value) {
          return value.second == config::writeText(place);
        };
        if (std::ranges::none_of(found.values, reads)) found.other_folders.push_back(place);
      }
      return found;
    };
    for (const auto& [left, place] : images) {
      const auto right = images.find(rightOf(left, all));
      if (right == images.end()) continue;
      for (const std::string& file : calibrations()) {
        auto found = probe(with(given_, {{"left", config::writeText(place)},
                                         {"right", config::writeText(right->second)},
                                         {"calibration", config::writeText(file)}}));
        if (found.isOk()) return noteOthers(std::move(found).value());
      }
    }
    for (const auto& [left, place] : images) {
      auto found = probe(with(given_, {{"left", config::writeText(place)}}));
      if (found.isOk()) return noteOthers(std::move(found).value());
    }
    return Status::invalidInput("no folder of images is read");
  }

  Names calibrations() const { return namesIn(path_, {".yaml", ".yml", ".xml", ".txt"}); }

  /// Takes the result with these parameters if the source reads it; otherwise keeps the reason.
  bool take(const SourceValues& more, bool is_told) {
    Result<Recording> tried = probe(with(best_.values, more));
    if (!tried.isOk()) {
      std::string reason = tried.status().message();
      std::ranges::replace(reason, '\n', ' ');
      if (is_told) best_.unused.push_back(std::move(reason));
      return false;
    }
    if (more[0].first == "calibration" && !tried.value().calibrated) return false;
    Recording found = std::move(tried).value();
    found.other_folders = best_.other_folders;
    found.unused = best_.unused;
    best_ = std::move(found);
    return true;
  }

  void tryCalibrations() {
    for (const std::string& file : calibrations()) {
      constexpr std::array kPatterns = {"*calib*", "*cam*", "*intrinsic*", "*sensor*"};
      const bool is_calibration = std::ranges::any_of(kPatterns, [&](const char* pattern) {
        return ::fnmatch(pattern, file.c_str(), FNM_CASEFOLD) == 0;
      });
      if (take({{"calibration", config::writeText(file)}}, is_calibration)) return;
    }
  }

  void tryStamps() {
    for (const std::string& file : namesIn(path_, {".csv", ".txt"})) {
      const SourceValues times = timesIn(path_ / file);
      if (!times.empty() && take(times, true)) return;
    }
    fs::path images = path_;
    for (const auto& [name, value] : best_.values) {
      if (name == "left") images = path_ / value;
    }
    const Names names = namesIn(images, kImageEndings);
    if (names.size() < 2) return;
    const std::string first = fs::path(names[0]).stem();
    const std::string second = fs::path(names[1]).stem();
    if (!isTime(first) || !isTime(second)) return;
    take({{"stamps_in_names", "true"}, {"stamps_unit", unitOf(first, second)}}, true);
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
  Never never_;
  Recording best_;
};

/// Calibrated pairs before single cameras (those with depth first), before uncalibrated ones,
/// before no images.
int rankOf(const Recording& r) {
  return (r.width > 0 ? 1 : 0) + (r.calibrated ? 2 : 0) + (r.baseline > 0 ? 2 : r.depth ? 1 : 0);
}

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
  const config::Loaded layouts =
      config::load(configFile("configs/init/layouts.yaml"), {}, config::processEnvironment());
  for (const config::Node& source : layouts.tree.children) {
    const auto met = [&](const config::Node& line) { return isMet(line.text, names); };
    if (std::ranges::any_of(source.children, met)) return source.key;
  }
  return "";
}

Recording lookAt(const fs::path& recording, const SourceValues& given,
                 const Invocation& invocation) {
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  std::string known = sourceFor(recording);
  SourceValues values;
  for (const auto& value : given) {
    if (value.first == "plugin") {
      known = value.second;
    } else {
      values.push_back(value);
    }
  }
  std::optional<Recording> best;
  std::string reasons;
  const auto tryOne = [&](const std::string& id) {
    const host::LoadedPlugin plugin = engine::loadFrom(catalogue, id, Role::Source);
    Search search(recording, plugin, values, invocation);
    if (search.declared("path") == nullptr) return;
    Result<Recording> found = search.run();
    if (!found.isOk()) {
      reasons += "\n  " + id + ": " + found.status().message();
    } else if (!best || rankOf(found.value()) > rankOf(*best)) {
      best = std::move(found).value();
    }
  };
  if (!known.empty()) {
    tryOne(known);
  } else {
    for (const host::Manifest& manifest : catalogue.manifests()) {
      const bool is_usable = !host::checkGate(manifest, host::HostIdentity::ofThisBuild());
      if (manifest.role == Role::Source && is_usable) tryOne(manifest.id);
    }
  }
  if (best) return *best;
  fail(ExitCode::Dataset, recording.string() + ": no source reads it" + reasons +
                              "\nParameters are given by --set NAME=VALUE; see "
                              "docs/your-camera.md");
}

}  // namespace tolman::app
