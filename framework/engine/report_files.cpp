// SPDX-License-Identifier: BSD-3-Clause
#include "engine/report_files.hpp"

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "engine/run_names.hpp"
#include "record/output_places.hpp"
#include "report/page.hpp"
#include "report/raster.hpp"

namespace tolman::run {
namespace {

namespace fs = std::filesystem;

/// The parsed configuration; the defaults if it has problems.
config::SystemConfig systemOf(const config::Loaded& loaded) {
  config::Problems problems = loaded.problems;
  config::SystemConfig system = config::parse(loaded, problems);
  return problems.empty() ? system : config::SystemConfig{};
}

/// The page of a run, evaluated by the settings of its configuration, or by the defaults if it
/// cannot be read.
Result<report::RunPage> pageOf(const record::RunReader& run, const report::UnitChoice& units) {
  const config::Loaded loaded = config::load(run.directory() / "config.resolved.yaml", {},
                                             [](const std::string&) { return std::nullopt; });
  const config::SystemConfig system = systemOf(loaded);
  auto data =
      report::readRun(run, system.evaluation, static_cast<std::uint64_t>(system.general.seed));
  if (!data.isOk()) return data.status();
  auto page = report::makePage(run, std::move(data).value(), units);
  if (page.isOk()) page.value().settings = loaded.tree;
  return page;
}

/// The files of a report. They are written together, when all are made.
class ReportFiles {
 public:
  explicit ReportFiles(fs::path folder) : folder_(std::move(folder)) {}

  /// Adds a figure to `figures/sub`; with `pixels` as PNG, too.
  Status addFigure(const std::string& sub, const std::string& name, const std::string& svg,
                   bool pixels) {
    add(sub, name + ".svg", svg);
    if (!pixels) return Status::ok();
    auto png = report::pngOf(svg);
    if (!png.isOk()) return png.status();
    add(sub, name + ".png", std::move(png).value());
    return Status::ok();
  }
  Status addFigures(const std::string& sub, const report::RunPage& page, bool pixels) {
    Status status;
    for (const report::PageFigure& figure : page.figures) {
      if (status.isOk()) status = addFigure(sub, figure.file, figure.svg, pixels);
    }
    if (status.isOk() && !page.neurons.is_null()) {
      add(sub, "neurons.json", page.neurons.dump() + "\n");
    }
    return status;
  }

  /// Writes all files, the page last; nothing through links into other folders.
  Result<std::vector<fs::path>> write(std::string page) {
    constexpr std::array<std::string_view, 1> kFigures = {"figures"};
    const std::vector<std::string_view> subs(subs_.begin(), subs_.end());
    Status status = record::refuseLinks(folder_, kFigures);
    if (status.isOk()) status = record::refuseLinks(folder_ / "figures", subs);
    if (!status.isOk()) return status;
    std::error_code ignored;  // writing fails with a better message
    for (const std::string& sub : subs_) fs::create_directories(folder_ / "figures" / sub, ignored);
    fs::create_directories(folder_, ignored);
    files_.push_back({folder_ / "report.html", std::move(page)});
    status = record::writeTogether(files_, "--out");
    if (!status.isOk()) return status;
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

}  // namespace

Result<std::vector<fs::path>> writeReport(
    const std::vector<std::unique_ptr<record::RunReader>>& runs, const fs::path& folder,
    const report::UnitChoice& units) {
  std::vector<report::RunPage> pages;
  std::vector<fs::path> directories;
  directories.reserve(runs.size());
  for (const auto& run : runs) directories.push_back(run->directory());
  const std::vector<std::string> names = distinctNames(directories);
  for (std::size_t i = 0; i < runs.size(); ++i) {  // reads all runs before it writes a file
    auto page = pageOf(*runs[i], units);
    if (!page.isOk()) return page.status();
    page.value().directory = names[i];
    pages.push_back(std::move(page).value());
  }
  ReportFiles files(folder);
  for (const report::RunPage& page : pages) {
    const Status status = files.addFigures(runs.size() == 1 ? "" : page.directory, page, true);
    if (!status.isOk()) return status;
  }
  const std::string comparison = report::comparisonFigure(pages);
  if (!comparison.empty()) {
    const Status status = files.addFigure("", "comparison", comparison, true);
    if (!status.isOk()) return status;
  }
  return files.write(report::html(pages));
}

Status writeReport(const record::RunReader& reader, report::RunData data,
                   const std::string& run_file) {
  auto page = report::makePage(reader, std::move(data));
  if (!page.isOk()) return page.status();
  page.value().provenance = nlohmann::ordered_json::parse(run_file);
  page.value().killed = false;
  ReportFiles files(reader.directory());
  const Status status = files.addFigures("", page.value(), false);
  return status.isOk() ? files.write(report::html({page.value()})).status() : status;
}

}  // namespace tolman::run
