// SPDX-License-Identifier: BSD-3-Clause
#include "app/report_files.hpp"

#include <set>
#include <string>
#include <utility>

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "record/atomic_file.hpp"
#include "report/comparison.hpp"
#include "report/page.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

/// A killed or foreign run without a readable configuration is evaluated by the defaults.
config::EvaluationSettings settingsOf(const fs::path& run) {
  const fs::path file = run / "config.resolved.yaml";
  if (!fs::exists(file)) return {};
  const config::Loaded loaded =
      config::load(file.string(), {}, [](const std::string&) { return std::nullopt; });
  config::Problems problems = loaded.problems;
  const config::SystemConfig system = config::parse(loaded, problems);
  return problems.empty() ? system.evaluation : config::EvaluationSettings{};
}

/// The run's own name, also of "runs/demo/"; a number tells namesakes apart.
std::string folderOf(const fs::path& run, std::set<std::string>& taken) {
  const fs::path path = fs::absolute(run).lexically_normal();
  const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
  std::string unique = name;
  for (int i = 2; !taken.insert(unique).second; ++i) unique = name + "-" + std::to_string(i);
  return unique;
}

Status writeFigures(const report::RunPage& page, const fs::path& folder,
                    std::vector<fs::path>& written) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (const report::Figure& figure : page.figures) {
    const fs::path file = folder / (figure.file + ".svg");
    const Status status = record::writeAtomically(file, figure.svg);
    if (!status.isOk()) return status;
    written.push_back(file);
  }
  return Status::ok();
}

}  // namespace

Result<std::vector<fs::path>> writeReport(const std::vector<fs::path>& runs,
                                          const fs::path& folder) {
  std::vector<report::RunPage> pages;
  std::set<std::string> taken;
  std::vector<fs::path> written{folder / "report.html"};
  for (const fs::path& run : runs) {
    auto page = report::makePage(run, settingsOf(run));
    if (!page.isOk()) return page.status();
    const std::string name = folderOf(run, taken);
    const fs::path figures = runs.size() == 1 ? folder / "figures" : folder / "figures" / name;
    const Status status = writeFigures(page.value(), figures, written);
    if (!status.isOk()) return status;
    pages.push_back(std::move(page).value());
  }
  if (const auto maps = report::sideBySide(pages, "map")) {
    written.push_back(folder / "figures/maps.svg");
    if (Status status = record::writeAtomically(written.back(), *maps); !status.isOk()) {
      return status;
    }
  }
  const Status status = record::writeAtomically(written.front(), report::html(pages));
  if (!status.isOk()) return status;
  return written;
}

Status writeReport(const record::RunReader& reader, report::RunData data) {
  const auto page = report::makePage(reader, std::move(data));
  if (!page.isOk()) return page.status();
  std::vector<fs::path> written;
  const Status status = writeFigures(page.value(), reader.directory() / "figures", written);
  if (!status.isOk()) return status;
  return record::writeAtomically(reader.directory() / "report.html", report::html({page.value()}));
}

}  // namespace tolman::app
