// SPDX-License-Identifier: BSD-3-Clause
// tolman report: figures and one self-contained page about runs, from their records.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/output_files.hpp"
#include "app/path_kind.hpp"
#include "app/program.hpp"
#include "engine/report_files.hpp"
#include "record/run_directory.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

constexpr std::size_t kMaxUnits = 1'000'000;

/// The options of the units; rows, columns and units are counted from 1.
struct UnitOptions {
  std::size_t head_direction = 1;
  std::vector<std::size_t> grid{1, 1};

  report::UnitChoice choice() const { return {head_direction - 1, grid[0] - 1, grid[1] - 1}; }
};

std::shared_ptr<UnitOptions> addUnitOptions(CLI::App& command) {
  auto units = std::make_shared<UnitOptions>();
  command
      .add_option("--hd-unit", units->head_direction,
                  "Head direction unit whose firing rate is drawn, counted from 1 (default: 1)")
      ->check(CLI::Range(std::size_t{1}, kMaxUnits));
  command
      .add_option(
          "--grid-unit", units->grid,
          "Row and column, from 1, of the grid unit whose firing rate is drawn (default: 1,1)")
      ->type_name("ROW,COLUMN")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(std::size_t{1}, kMaxUnits));
  return units;
}

/// Refuses a folder with another run, or with a report or figures. In the directory of the run
/// itself they are Tolman's own.
void refuseOther(const std::string& run, const std::filesystem::path& folder, bool replace) {
  requireOrEnd(record::RunDirectory::mayTakeFilesOf(run, folder));
  std::error_code ignored;
  if (std::filesystem::equivalent(run, folder, ignored)) return;
  refuseReplacing({folder / "report.html"}, replace, "--out");
  refuseFilled(folder / "figures", replace, "--out");
}

}  // namespace

void addReportCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("report", "Figures and a page about runs (finished, running or killed)");
  auto runs = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  command->add_option("run", *runs, "Run directories; several are shown side by side")
      ->type_name("RUN")
      ->required();
  command->add_option("--out", *out, "Folder to write to (default: the first run directory)")
      ->type_name("FOLDER")
      ->check(notEmpty);
  auto replace = std::make_shared<bool>(false);
  addForce(*command, *replace, "Replace the report that the --out folder holds");
  const auto units = addUnitOptions(*command);
  command->callback([runs, out, replace, units, &invocation] {
    for (const std::string& run : *runs) requireRun(run);
    const std::filesystem::path folder = out->empty() ? runs->front() : *out;
    if (!out->empty()) refuseOther(runs->front(), folder, *replace);
    std::vector<std::unique_ptr<record::RunReader>> readers;
    for (const std::string& run : *runs) {
      readers.push_back(valueOrEnd(record::RunReader::open(run)));
    }
    printFiles(valueOrEnd(run::writeReport(readers, folder, units->choice())), invocation);
    for (const auto& reader : readers) {
      warnOfChangedRecord(*reader);
      warnOfRunFiles(reader->directory());
    }
  });
}

}  // namespace tolman::app
