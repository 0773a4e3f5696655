// SPDX-License-Identifier: BSD-3-Clause
#include "engine/results.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "config/json_text.hpp"
#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/export.hpp"
#include "report/figures.hpp"
#include "report/page.hpp"
#include "report/svg.hpp"

namespace tolman::engine {
namespace {

namespace fs = std::filesystem;

/// The page of a run, evaluated by the settings of its configuration, or by the defaults if it
/// cannot be read.
Result<report::RunPage> pageOf(const record::RunReader& run, const report::UnitChoice& units) {
  config::Node tree;
  const config::SystemConfig system = configOf(run.directory(), &tree);
  auto data =
      report::readRun(run, system.evaluation, static_cast<std::uint64_t>(system.general.seed));
  if (!data.isOk()) return data.status();
  auto page = report::makePage(run.directory(), std::move(data).value(), units);
  if (page.isOk()) page.value().settings = tree;
  return page;
}

/// Both views of the first loops and near misses.
void addLoopViews(report::RunPage& page, const record::RunReader& run, const ViewsOfRun& viewsOf) {
  constexpr std::size_t kMost = 12;  // bounds the size of the page
  std::vector<report::LoopStory> stories = page.data.loops;
  std::erase_if(stories, [](const report::LoopStory& story) { return story.earlier < 0; });
  if (stories.size() > kMost) stories.resize(kMost);
  std::set<std::int64_t> frames;
  for (const report::LoopStory& story : stories) frames.insert({story.earlier, story.frame});
  std::map<std::int64_t, Image> views = viewsOf(run, frames);
  for (const report::LoopStory& story : stories) {
    std::string pair = report::pairFigure(story, views[story.earlier], views[story.frame]);
    if (pair.empty()) continue;
    page.figures.push_back({"loop-" + std::to_string(story.frame), story.text(), std::move(pair)});
  }
}

/// The files of a report. They are written together, when all are made.
class ReportFiles {
 public:
  explicit ReportFiles(fs::path folder) : folder_(std::move(folder)) {}

  /// Adds figures to `figures/sub`; with `pixels` as PNG, too.
  Status addFigures(const std::string& sub, const std::vector<report::PageFigure>& figures,
                    bool pixels) {
    for (const report::PageFigure& figure : figures) {
      add(sub, figure.file + ".svg", figure.svg);
      if (!pixels) continue;
      auto png = report::pngOf(figure.svg);
      if (!png.isOk()) return png.status();
      add(sub, figure.file + ".png", std::move(png).value());
    }
    return Status::ok();
  }
  Status addFigures(const std::string& sub, const report::RunPage& page, bool pixels) {
    const Status status = addFigures(sub, page.figures, pixels);
    if (!page.neurons.is_null()) add(sub, "neurons.json", page.neurons.dump() + "\n");
    return status;
  }

  /// Writes all files, the page last.
  Result<std::vector<fs::path>> write(std::string page) {
    std::error_code ignored;  // writing fails with a better message
    for (const std::string& sub : subs_) fs::create_directories(folder_ / "figures" / sub, ignored);
    fs::create_directories(folder_, ignored);
    files_.push_back({folder_ / "report.html", std::move(page)});
    if (Status status = record::writeOutputs(files_); !status.isOk()) return status;
    std::vector<fs::path> written{files_.back().path};
    for (const record::OutputFile& file : files_) {
      if (file.path != written.front()) written.push_back(file.path);
    }
    return written;
  }

 private:
  void add(const std::string& sub, const std::string& name, std::string bytes) {
    subs_.insert(sub);
    files_.push_back({folder_ / "figures" / sub / name, std::move(bytes)});
  }
  fs::path folder_;
  std::set<std::string> subs_;
  std::vector<record::OutputFile> files_;
};

using Parts = std::vector<std::string>;

/// The parts of the absolute path, without an empty last part as of "runs/demo/"; none for "".
Parts partsOf(const fs::path& run) {
  Parts parts;
  std::error_code error;
  const fs::path whole = fs::absolute(run, error);
  if (error) return parts;
  for (const fs::path& part : whole.lexically_normal().relative_path()) {
    if (!part.empty()) parts.push_back(part.string());
  }
  return parts;
}

std::string joined(const Parts& parts) { return fmt::format("{}", fmt::join(parts, "-")); }

}  // namespace

config::SystemConfig configOf(const std::filesystem::path& run, config::Node* tree) {
  const config::Loaded loaded = config::load(run / "config.resolved.yaml", {},
                                             [](const std::string&) { return std::nullopt; });
  config::Problems problems = loaded.problems;
  config::SystemConfig system = config::parse(loaded, problems);
  if (tree != nullptr) *tree = loaded.tree;
  return problems.empty() ? system : config::SystemConfig{};
}

Result<Results> writeResults(const std::filesystem::path& directory,
                             const config::EvaluationSettings& settings, std::uint64_t seed) {
  auto opened = record::RunReader::open(directory);
  if (!opened.isOk()) return opened.status();
  const record::RunReader& reader = *opened.value();
  Status status = record::exportRun(reader, directory).status();
  if (!status.isOk()) return status;
  auto run = report::readRun(reader, settings, seed);
  if (!run.isOk()) return run.status();
  const report::RunData& data = run.value();
  status = record::writeAtomically(directory / "metrics.json",
                                   config::jsonText(evaluation::toJson(data.metrics), 2) + "\n");
  if (status.isOk()) {
    status = record::writeAtomically(directory / "map.svg",
                                     report::mapFigure({report::pictureOf(data, data.name)}));
  }
  if (status.isOk()) status = record::writeResultsDigest(directory);
  if (!status.isOk()) return status;
  return Results{std::move(opened).value(), std::move(run).value()};
}

std::vector<std::string> distinctNames(const std::vector<fs::path>& runs) {
  std::vector<Parts> paths;
  for (const fs::path& run : runs) paths.push_back(partsOf(run));
  const std::set<Parts> different(paths.begin(), paths.end());
  const auto share = [&](const auto& partOf) {
    return different.size() > 1 && std::ranges::all_of(paths, [&](const Parts& parts) {
             return parts.size() > 1 && partOf(parts) == partOf(paths.front());
           });
  };
  while (share([](const Parts& parts) { return parts.back(); })) {
    for (Parts& parts : paths) parts.pop_back();
  }
  std::set<std::string> last;
  for (const Parts& parts : paths) last.insert(parts.empty() ? "" : parts.back());
  const bool is_enough = last.size() == different.size();
  while (!is_enough && share([](const Parts& parts) { return parts.front(); })) {
    for (Parts& parts : paths) parts.erase(parts.begin());
  }
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const Parts& parts : paths) {
    const std::string first = !is_enough ? joined(parts) : parts.empty() ? "" : parts.back();
    names.push_back(first);
    for (int i = 2; !taken.insert(names.back()).second; ++i) {
      names.back() = first + "-" + std::to_string(i);
    }
  }
  return names;
}

Result<std::vector<fs::path>> writeReport(
    const std::vector<std::unique_ptr<record::RunReader>>& runs, const fs::path& folder,
    const report::UnitChoice& units, const ViewsOfRun& views) {
  std::vector<report::RunPage> pages;
  std::vector<fs::path> directories;
  directories.reserve(runs.size());
  for (const auto& run : runs) directories.push_back(run->directory());
  const std::vector<std::string> names = distinctNames(directories);
  for (std::size_t i = 0; i < runs.size(); ++i) {  // reads all runs before it writes a file
    auto page = pageOf(*runs[i], units);
    if (!page.isOk()) return page.status();
    page.value().directory = names[i];
    if (views) addLoopViews(page.value(), *runs[i], views);
    pages.push_back(std::move(page).value());
  }
  ReportFiles files(folder);
  for (const report::RunPage& page : pages) {
    const Status status = files.addFigures(runs.size() == 1 ? "" : page.directory, page, true);
    if (!status.isOk()) return status;
  }
  const std::string comparison = report::comparisonFigure(pages);
  if (!comparison.empty()) {
    const Status status = files.addFigures("", {{"comparison", "", comparison}}, true);
    if (!status.isOk()) return status;
  }
  return files.write(report::html(pages));
}

Status writeReport(const record::RunReader& reader, report::RunData data,
                   const std::string& run_file) {
  auto page = report::makePage(reader.directory(), std::move(data));
  if (!page.isOk()) return page.status();
  page.value().provenance = nlohmann::ordered_json::parse(run_file);
  page.value().killed = false;
  ReportFiles files(reader.directory());
  const Status status = files.addFigures("", page.value(), false);
  return status.isOk() ? files.write(report::html({page.value()})).status() : status;
}

}  // namespace tolman::engine
