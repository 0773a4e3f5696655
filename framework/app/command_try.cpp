// SPDX-License-Identifier: BSD-3-Clause
// tolman try: which combination of modules is best on a recording? Writes the configuration of
// `tolman init` and a sweep over the alternatives, runs it, and ranks the runs.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/options.hpp"
#include "app/recording.hpp"
#include "base/text_file.hpp"
#include "experiment/comparison.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using experiment::Ranked;
using experiment::RunRow;

struct TryCommand {
  std::string recording;
  std::string carrier;
  std::vector<std::string> values;
  Output out;
  std::size_t jobs = 0;
};

/// The sweep for the stages that init chooses.
std::string sweepFor(const std::string& stages) {
  const bool is_pair = stages.ends_with("_stereo.yaml");
  const char* name = stages == "motion.yaml"       ? "motion"
                     : stages == "car_stereo.yaml" ? "car"
                     : is_pair                     ? "pair"
                                                   : "camera";
  return configFile(fmt::format("configs/init/try/{}.yaml", name));
}

/// Without truth: the first run that was tracked, and made a map of more than one experience if one
/// did. The first is that of init.
const RunRow& firstTracked(const std::vector<RunRow>& rows) {
  return *std::ranges::max_element(rows, {}, [](const RunRow& run) {
    const auto code = run.metrics.find("exit_code");
    const auto experiences = run.metrics.find("experiences");
    const bool is_tracked = code == run.metrics.end() || code->second == 0;
    return std::pair(is_tracked, experiences != run.metrics.end() && experiences->second > 1);
  });
}

std::string verdictOf(const std::vector<Ranked>& ranked, const RunRow& best) {
  if (ranked.empty()) {
    return row("verdict",
               "without true poses nobody can say which is best; evaluation.truth "
               "names a file of them") +
           row("kept", best.name + ": the first that was tracked");
  }
  const Ranked& first = ranked.front();
  const auto alike = std::ranges::count_if(ranked, &Ranked::as_good) - 1;
  std::string text =
      row("best", fmt::format("{}: {:.3g} m (95 %: {:.3g} to {:.3g})", best.name, first.rmse_m,
                              first.interval.low, first.interval.high));
  text += row("verdict",
              alike == 0 ? fmt::format("better than the {} others", ranked.size() - 1)
                         : fmt::format("this recording cannot decide between it and {} of the {} "
                                       "others, marked in the table",
                                       alike, ranked.size() - 1));
  const auto returns = best.metrics.find("returns");
  if (returns != best.metrics.end() && returns->second == 0) {
    text += row("", "the recording never returns to a place: cells and maps cannot be compared");
  }
  return text;
}

void tryOut(const TryCommand& command, Invocation& invocation) {
  const fs::path out = command.out.path;
  refuseExisting({out}, command.out.replace, "--out");
  const Initial initial =
      initialFor(command.recording, valuesIn(command.values, ""), command.carrier, invocation);
  std::error_code error;
  fs::create_directories(out, error);
  if (error) fail(ExitCode::Record, out.string() + ": " + error.message());
  const std::string sweep =
      valueOf(text_encoding::readText(sweepFor(initial.stages)), ExitCode::Configuration);
  failUnless(record::writeOutput(out / "first.yaml", initial.text));
  failUnless(record::writeOutput(out / "try.yaml", sweep));
  const fs::path runs = out / "runs";
  Invocation of_sweep = invocation;
  of_sweep.quiet |= invocation.json;
  of_sweep.json = false;
  if (runSweep(out / "try.yaml", runs, command.jobs, of_sweep) == ExitCode::Interrupted) {
    invocation.exit_code = ExitCode::Interrupted;
    return;
  }
  const auto rows = valueOf(experiment::readRunRows({runs}));
  if (rows.empty()) fail(ExitCode::PluginFailed, "no combination could be run; see above");
  const auto ranked = valueOf(experiment::rankedRuns(rows));
  const RunRow& best = ranked.empty() ? firstTracked(rows) : *ranked.front().run;
  const fs::path frozen = best.directory.parent_path() / "config.yaml";
  failUnless(record::writeOutput(out / "best.yaml",
                                 valueOf(text_encoding::readText(frozen), ExitCode::Record)));
  const experiment::Table table = experiment::tableOf(ranked, rows);
  if (invocation.json) {
    std::cout << experiment::jsonOf(table);
    return;
  }
  std::cout << "\n"
            << experiment::textOf(table) << "\n"
            << verdictOf(ranked, best) << row("config", (out / "best.yaml").string());
}

}  // namespace

void addTryCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand(
      "try", "Run the sensible combinations of modules on a recording, and rank them");
  auto options = std::make_shared<TryCommand>();
  addArgument(command, "recording", options->recording, "RECORDING",
              "Folder or file of the recording");
  options->out
      .add(command, "FOLDER", "Folder to write: first.yaml, try.yaml, runs, best.yaml",
           "Use a folder that holds other files")
      ->required();
  addChoice(command, "--motion", options->carrier, {"car", "hand", "toy"},
            "What carries the camera (default: a guess)");
  addList(command, "--set", options->values, "NAME=VALUE",
          "Parameter of the source: --set a=b (repeatable)")
      ->check(isAssignment);
  addOption(command, "--jobs", options->jobs, "N", "Runs at a time (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  command.callback([options, &invocation] { tryOut(*options, invocation); });
}

}  // namespace tolman::app
