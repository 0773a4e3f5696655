// SPDX-License-Identifier: BSD-3-Clause
#include "app/report_files.hpp"

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "record/atomic_file.hpp"
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
  std::vector<fs::path> written{folder / "report.html"};
  for (const fs::path& run : runs) {
    auto page = report::makePage(run, settingsOf(run));
    if (!page.isOk()) return page.status();
    const fs::path figures =
        runs.size() == 1 ? folder / "figures" : folder / "figures" / run.filename();
    const Status status = writeFigures(page.value(), figures, written);
    if (!status.isOk()) return status;
    pages.push_back(std::move(page).value());
  }
  const Status status = record::writeAtomically(written.front(), report::html(pages));
  if (!status.isOk()) return status;
  return written;
}

}  // namespace tolman::app
