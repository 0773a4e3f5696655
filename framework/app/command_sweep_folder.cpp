// SPDX-License-Identifier: BSD-3-Clause
// Commands on the folder of a sweep: status, collect, archive and point.
#include <fmt/format.h>

#include <chrono>
#include <iostream>

#include "app/options.hpp"
#include "config/values.hpp"
#include "experiment/point_run.hpp"
#include "experiment/run_table.hpp"
#include "experiment/sweep_archive.hpp"
#include "host/child_process.hpp"
#include "host/scratch_folder.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

using experiment::PlannedRun;
using experiment::PointState;
namespace fs = std::filesystem;

/// The runs of the folder; fails if it has none.
experiment::FrozenRuns runsOf(const std::string& folder, ExitCode code) {
  experiment::FrozenRuns runs = experiment::frozenRuns(folder);
  if (runs.empty()) {
    fail(code, folder + ": " + config::absence(folder, "holds no runs of a sweep"));
  }
  return runs;
}

/// Warns of runs that failed or are not done: what is written is without them.
void warnOfUnfinished(const fs::path& sweep) {
  const std::string text = experiment::unfinishedText(sweep);
  if (!text.empty()) std::cerr << "warning: " + text + "\n";
}

void runPoint(const std::string& folder, experiment::PointRunOptions& options,
              Invocation& invocation) {
  const engine::Interrupts interrupts;
  options.plugin_paths = invocation.plugin_paths;
  options.command_line = invocation.command_line;
  options.quiet = invocation.quiet;
  options.find_config = configFile;
  options.exit_code = [](const engine::Outcome& o) { return static_cast<int>(exitCode(o)); };
  options.failure_code = [](const engine::Failure& f) {
    return static_cast<int>(exitCode(f.kind));
  };
  const auto outcome = experiment::runPoint(folder, options, interrupts);
  if (!outcome.message.empty()) std::cerr << outcome.message << "\n";
  invocation.exit_code = static_cast<ExitCode>(outcome.exit_code);
  if (outcome.state == PointState::Interrupted) invocation.exit_code = ExitCode::Interrupted;
  // Its files are damaged, exchanged, or of another run, whatever it ended with.
  const bool is_damaged = outcome.state == PointState::Failed && outcome.exit_code == 0;
  if (is_damaged) invocation.exit_code = ExitCode::PluginFailed;
}

void printStatus(const std::string& folder, const Invocation& invocation) {
  const experiment::FrozenRuns runs = runsOf(folder, ExitCode::Usage);
  std::map<PointState, int> counts;
  int lost = 0;
  auto list = nlohmann::ordered_json::array();
  std::string failed;
  for (const PlannedRun& run : runs.planned) {
    const auto outcome = experiment::outcomeOf(fs::path(folder) / run.folder);
    ++counts[outcome.state];
    list.push_back({{"name", run.name},
                    {"folder", run.folder},
                    {"state", enumName(outcome.state)},
                    {"exit_code", outcome.exit_code},
                    {"message", outcome.message},
                    {"wall_s", outcome.wall_s}});
    if (outcome.lostTracking()) ++lost;
    if (outcome.message.empty() && !outcome.lostTracking()) continue;
    failed += "  " + run.name + "\n    " + outcome.message + "\n";
  }
  for (const std::string& missing : runs.missing) {
    list.push_back({{"name", ""}, {"folder", missing}, {"state", "missing"}});
    failed += "  " + missing + "\n";
  }
  if (invocation.json) {
    std::cout << jsonText(list);
    return;
  }
  const auto line = [](std::string_view name, std::size_t count, const char* text) {
    if (count > 0) std::cout << fmt::format("{:<13}{}{}\n", name, count, text);
  };
  for (const auto& [state, count] : counts) line(enumName(state), count, "");
  line("lost", lost, " of those that are done lost tracking");
  line("missing", runs.missing.size(), " without a readable point.json");
  line("not counted", runs.earlier.size(), " of earlier plans");
  std::cout << failed;
}

struct CollectCommand {
  std::string sweep;
  Output out;
  std::vector<std::string> metrics;
};

void collect(const CollectCommand& command, const Invocation& invocation) {
  const std::string& out = command.out.path;
  if (!out.empty()) refuseExisting({out}, command.out.replace, "--out");
  const auto rows = valueOf(experiment::readRunRows({command.sweep}));
  warnOfUnfinished(command.sweep);
  if (rows.empty()) fail(ExitCode::Dataset, command.sweep + ": no run is done");
  const fs::path file = out.empty() ? fs::path(command.sweep) / "results.csv" : fs::path(out);
  failUnless(record::writeOutput(file, experiment::csvOf(rows, command.metrics)));
  printFiles({file}, invocation);
}

struct ArchiveCommand {
  std::string sweep;
  Output out;
};

void archive(const ArchiveCommand& command, const Invocation& invocation) {
  fs::path from = fs::absolute(command.sweep).lexically_normal();
  if (!from.has_filename()) from = from.parent_path();
  const std::string& out = command.out.path;
  const fs::path file = fs::absolute(out.empty() ? from.string() + ".tar.gz" : out);
  (void)runsOf(command.sweep, ExitCode::Dataset);
  refuseExisting({file}, command.out.replace, "--out");
  warnOfUnfinished(from);
  const host::ScratchFolder files("tolman-archive");
  if (files.path().empty()) fail(ExitCode::Record, host::kNoScratchFolder);
  failUnless(experiment::writeSweepArchive(from, files.path() / from.filename()));
  const fs::path partial = file.string() + ".partial";
  host::ChildProcess tar(
      {"/usr/bin/env", "tar", "--sort=name", "--owner=0", "--group=0", "--mtime=@0", "-C",
       files.path().string(), "-czf", partial.string(), from.filename().string()},
      {});
  const host::ProcessEnd end = tar.end(std::chrono::hours(24));
  std::error_code error;
  const bool is_written = end.signal == 0 && end.exit_code == 0;
  if (is_written) fs::rename(partial, file, error);
  if (!is_written || error) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    fail(ExitCode::Record,
         file.string() + ": not written (" + (error ? error.message() : "tar " + end.text()) + ")");
  }
  printFiles({file}, invocation);
}

}  // namespace

void addSweepCommands(CLI::App& sweep, Invocation& invocation) {
  CLI::App& status =
      *sweep.add_subcommand("status", "What became of the runs of a sweep, from their folders");
  auto asked = std::make_shared<std::string>();
  addArgument(status, "sweep", *asked, "FOLDER", "Folder of the sweep");
  status.callback([asked, &invocation] { printStatus(*asked, invocation); });

  CLI::App& collecting =
      *sweep.add_subcommand("collect", "Factors and metrics of the runs that are done, as CSV");
  auto table = std::make_shared<CollectCommand>();
  addArgument(collecting, "sweep", table->sweep, "FOLDER", "Folder of the sweep");
  addList(collecting, "--metric", table->metrics, "KEY",
          "Only this key of metrics.json (repeatable; default: all)");
  table->out.add(collecting, "FILE", "File (default: results.csv in the sweep)",
                 "Replace the file of --out");
  collecting.callback([table, &invocation] { collect(*table, invocation); });

  CLI::App& archiving = *sweep.add_subcommand(
      "archive", "Configurations, digests, results and commands, to run it again elsewhere");
  auto packed = std::make_shared<ArchiveCommand>();
  addArgument(archiving, "sweep", packed->sweep, "FOLDER", "Folder of the sweep");
  packed->out.add(archiving, "FILE", "Archive to write (default: SWEEP.tar.gz)",
                  "Replace the file");
  archiving.callback([packed, &invocation] { archive(*packed, invocation); });

  CLI::App& point = *sweep.add_subcommand("point", "Run one frozen run of a sweep");
  auto folder = std::make_shared<std::string>();
  auto options = std::make_shared<experiment::PointRunOptions>();
  addArgument(point, "run", *folder, "FOLDER", "Its folder");
  point.add_flag("--retry", options->retry, "Run it again when it has failed");
  addOption(point, "--threads", options->threads, "N", "Threads, where the configuration has 0")
      ->check(CLI::Range(1, 1024));
  point.callback([folder, options, &invocation] { runPoint(*folder, *options, invocation); });
}

}  // namespace tolman::app
