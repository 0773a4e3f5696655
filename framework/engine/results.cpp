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
#include "report/svg.hpp"

namespace tolman::engine {
namespace {

namespace fs = std::filesystem;

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

/// Writes the figures, with `pixels` as PNG too, and then the page.
Result<std::vector<fs::path>> writePages(const std::vector<report::RunPage>& pages,
                                         const fs::path& folder, bool pixels) {
  std::vector<record::OutputFile> files;
  for (const report::RunPage& page : pages) {
    const fs::path figures = folder / "figures" / (pages.size() > 1 ? page.directory : "");
    for (const report::PageFigure& figure : page.figures) {
      files.push_back({figures / (figure.file + ".svg"), figure.svg});
      if (!pixels) continue;
      auto png = report::pngOf(figure.svg);
      if (!png.isOk()) return png.status();
      files.push_back({figures / (figure.file + ".png"), std::move(png).value()});
    }
    if (!page.neurons.is_null()) {
      files.push_back({figures / "neurons.json", page.neurons.dump() + "\n"});
    }
    std::error_code ignored;  // writing fails with a better message
    fs::create_directories(figures, ignored);
  }
  files.push_back({folder / "report.html", report::html(pages)});
  if (Status status = record::writeOutputs(files); !status.isOk()) return status;
  std::vector<fs::path> written{files.back().path};
  files.pop_back();
  for (const record::OutputFile& file : files) written.push_back(file.path);
  return written;
}

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

config::SystemConfig configOf(const std::filesystem::path& run) {
  const config::Loaded loaded = config::load(run / "config.resolved.yaml", {},
                                             [](const std::string&) { return std::nullopt; });
  config::Problems problems = loaded.problems;
  config::SystemConfig system = config::parse(loaded, problems);
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
    const ViewsOfRun& views) {
  std::vector<fs::path> directories;
  directories.reserve(runs.size());
  for (const auto& run : runs) directories.push_back(run->directory());
  const std::vector<std::string> names = distinctNames(directories);
  std::vector<report::RunPage> pages;
  for (const auto& run : runs) {  // reads all runs before it writes a file
    const config::SystemConfig system = configOf(run->directory());
    auto data =
        report::readRun(*run, system.evaluation, static_cast<std::uint64_t>(system.general.seed));
    if (!data.isOk()) return data.status();
    pages.push_back(report::makePage(run->directory(), std::move(data).value()));
    pages.back().directory = names[pages.size() - 1];
    if (views) addLoopViews(pages.back(), *run, views);
  }
  return writePages(pages, folder, true);
}

Status writeReport(const record::RunReader& reader, report::RunData data,
                   const std::string& run_file) {
  report::RunPage page = report::makePage(reader.directory(), std::move(data));
  page.provenance = nlohmann::ordered_json::parse(run_file);
  page.killed = false;
  return writePages({page}, reader.directory(), false).status();
}

}  // namespace tolman::engine
