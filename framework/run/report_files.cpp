// SPDX-License-Identifier: BSD-3-Clause
#include "run/report_files.hpp"

#include <string>
#include <utility>

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "record/atomic_file.hpp"
#include "report/page.hpp"
#include "report/raster.hpp"
#include "run/run_names.hpp"

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

/// Writes figures into one folder, and keeps the names of the files.
class FigureFolder {
 public:
  FigureFolder(fs::path folder, bool pixels, std::vector<fs::path>& written)
      : folder_(std::move(folder)), pixels_(pixels), written_(written) {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);  // on failure writing the first file fails
  }

  Status add(const std::string& name, const std::string& svg) {
    const Status status = write(name + ".svg", svg);
    if (!status.isOk() || !pixels_) return status;
    const auto png = report::pngOf(svg);
    return png.isOk() ? write(name + ".png", png.value()) : png.status();
  }
  Status addAll(const report::RunPage& page) {
    Status status;
    for (const report::PageFigure& figure : page.figures) {
      if (status.isOk()) status = add(figure.file, figure.svg);
    }
    if (status.isOk() && !page.neurons.is_null()) {
      status = write("neurons.json", page.neurons.dump() + "\n");
    }
    return status;
  }

 private:
  Status write(const std::string& name, const std::string& bytes) {
    written_.push_back(folder_ / name);
    return record::writeAtomically(written_.back(), bytes);
  }
  fs::path folder_;
  bool pixels_;
  std::vector<fs::path>& written_;
};

}  // namespace

Result<std::vector<fs::path>> writeReport(
    const std::vector<std::unique_ptr<record::RunReader>>& runs, const fs::path& folder,
    const report::UnitChoice& units) {
  std::vector<report::RunPage> pages;
  std::vector<fs::path> directories;
  for (const auto& run : runs) directories.push_back(run->directory());
  const std::vector<std::string> names = distinctNames(directories);
  for (std::size_t i = 0; i < runs.size(); ++i) {  // reads all runs before it writes a file
    auto page = pageOf(*runs[i], units);
    if (!page.isOk()) return page.status();
    page.value().directory = names[i];
    pages.push_back(std::move(page).value());
  }
  std::vector<fs::path> written{folder / "report.html"};
  for (const report::RunPage& page : pages) {
    FigureFolder figures(folder / "figures" / (runs.size() == 1 ? "" : page.directory), true,
                         written);
    const Status status = figures.addAll(page);
    if (!status.isOk()) return status;
  }
  const std::string comparison = report::comparisonFigure(pages);
  if (!comparison.empty()) {
    FigureFolder figures(folder / "figures", true, written);
    const Status status = figures.add("comparison", comparison);
    if (!status.isOk()) return status;
  }
  const Status status = record::writeAtomically(written.front(), report::html(pages));
  if (!status.isOk()) return status;
  return written;
}

Status writeReport(const record::RunReader& reader, report::RunData data) {
  const auto page = report::makePage(reader, std::move(data));
  if (!page.isOk()) return page.status();
  std::vector<fs::path> written;
  FigureFolder figures(reader.directory() / "figures", false, written);
  const Status status = figures.addAll(page.value());
  if (!status.isOk()) return status;
  return record::writeAtomically(reader.directory() / "report.html", report::html({page.value()}));
}

}  // namespace tolman::run
