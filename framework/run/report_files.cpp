// SPDX-License-Identifier: BSD-3-Clause
#include "run/report_files.hpp"

#include <set>
#include <string>
#include <utility>

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "record/atomic_file.hpp"
#include "report/page.hpp"
#include "report/raster.hpp"

namespace tolman::run {
namespace {

namespace fs = std::filesystem;

/// Configuration of the run; the defaults where it cannot be read.
config::SystemConfig systemOf(const fs::path& run) {
  const fs::path file = run / "config.resolved.yaml";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  const config::Loaded loaded =
      config::load(file.string(), {}, [](const std::string&) { return std::nullopt; });
  config::Problems problems = loaded.problems;
  config::SystemConfig system = config::parse(loaded, problems);
  return problems.empty() ? system : config::SystemConfig{};
}

/// Name of the run directory, also for "runs/demo/"; a number makes equal names unique.
std::string folderOf(const fs::path& run, std::set<std::string>& taken) {
  const fs::path path = fs::absolute(run).lexically_normal();
  const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
  std::string unique = name;
  for (int i = 2; !taken.insert(unique).second; ++i) unique = name + "-" + std::to_string(i);
  return unique;
}

/// Writes figures into one folder, and keeps the names of the files.
class FigureFolder {
 public:
  FigureFolder(fs::path folder, bool pixels, std::vector<fs::path>& written)
      : folder_(std::move(folder)), pixels_(pixels), written_(written) {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);  // the first file reports a missing folder
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

Result<std::vector<fs::path>> writeReport(const std::vector<fs::path>& runs, const fs::path& folder,
                                          const report::UnitChoice& units) {
  std::vector<report::RunPage> pages;
  std::set<std::string> taken;
  for (const fs::path& run : runs) {  // all before the first file: one that fails leaves nothing
    const config::SystemConfig system = systemOf(run);
    const auto seed = static_cast<std::uint64_t>(system.general.seed);
    auto page = report::makePage(run, system.evaluation, units, seed);
    if (!page.isOk()) return page.status();
    page.value().directory = folderOf(run, taken);
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
  const Status status = record::writeAtomically(written.front(), report::html(pages, comparison));
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
