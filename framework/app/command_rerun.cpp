// SPDX-License-Identifier: BSD-3-Clause
// tolman rerun: the same run again, compared byte for byte.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "app/exit_guard.hpp"
#include "app/output_files.hpp"
#include "app/path_kind.hpp"
#include "app/run_changes.hpp"
#include "app/summary.hpp"
#include "app/terminal_output.hpp"
#include "engine/run.hpp"
#include "engine/terminal.hpp"
#include "record/digest.hpp"
#include "record/run_directory.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct RerunCommand {
  std::string run;
  std::string out;
  bool verify = false;
  bool replace = false;
};

/// The digests of results.sha256; there must be some.
std::map<std::string, std::string> expectedDigests(const fs::path& run) {
  auto digests = record::resultsDigests(run);
  if (!digests.empty()) return digests;
  throw Ended{ExitCode::Dataset, (run / "results.sha256").string() + ": has no digests"};
}

ExitCode compare(const fs::path& before, const fs::path& after, const Invocation& invocation) {
  const auto expected = expectedDigests(before);
  const auto found = record::resultsDigests(after);
  Json files = Json::object();
  const std::set<std::string> changed = record::changedResults(before);
  bool same = expected.size() == found.size() && changed.empty();
  for (const auto& [file, digest] : expected) {
    const auto other = found.find(file);
    const char* text = other == found.end()      ? "missing"
                       : other->second == digest ? "same"
                                                 : "differs";
    same = same && text == std::string_view("same");
    files[file] = text;
    if (changed.contains(file)) files[file] = "changed since it was recorded";
  }
  for (const auto& [file, digest] : found) {
    if (!expected.contains(file)) files[file] = "not in results.sha256 of the earlier run";
  }
  const auto changes = resultChanges(before, after);
  if (invocation.json) {
    std::cout << jsonText(Json{{"same", same}, {"files", files}, {"changes", changes}});
  } else if (!invocation.quiet) {
    for (const auto& [file, text] : files.items()) {
      std::cout << fmt::format("{:<20}{}\n", file, text.get<std::string>());
    }
    for (const std::string& change : changes) std::cout << "  " << run::printable(change) << "\n";
    if (!same && changed.empty() && changes.empty())
      std::cout << "  nothing that run.json knows has changed\n";
  }
  if (!same && invocation.quiet && !invocation.json) {
    std::cerr << run::printable(after.string()) + ": its results are not those of " +
                     run::printable(before.string()) + "; leave out --quiet to see which\n";
  }
  return same ? ExitCode::Ok : ExitCode::Record;
}

/// The outcome of a run that is not compared, with warnings of data that are not the recorded ones.
ExitCode show(const run::Outcome& outcome, const fs::path& before, const Invocation& invocation) {
  std::vector<std::string> changes;
  if (!outcome.directory.empty()) changes = dataChanges(before, outcome.directory);
  for (const std::string& change : changes) {
    if (invocation.quiet) break;
    std::cerr << "warning: " + run::printable(change) + " than when " +
                     run::printable(before.string()) +
                     " was recorded; the new run is of the data as they are now, and its results "
                     "may differ (--verify compares them)\n";
  }
  return printOutcome(outcome, invocation, {{"changes", changes}});
}

ExitCode execute(const RerunCommand& command, const Invocation& invocation) {
  const run::Interrupts interrupts;
  requireRun(command.run, {PathKind::Point});
  fs::path before = fs::absolute(command.run).lexically_normal();
  if (!before.has_filename()) before = before.parent_path();
  // The folder of a point of a sweep contains its run in the folder `run`.
  const bool is_point = fs::exists(before / "point.json") && !fs::exists(before / "run.json");
  if (is_point && fs::exists(before / "run/run.json")) before /= "run";
  const fs::path out =
      command.out.empty() ? fs::path(before.string() + "-again") : fs::path(command.out);
  std::error_code ignored;
  if (fs::equivalent(before, out, ignored)) {
    throw Ended{ExitCode::Usage,
                out.string() + ": is the run itself; give another folder with --out"};
  }
  if (!fs::exists(before / "config.resolved.yaml", ignored)) {
    throw Ended{ExitCode::Configuration,
                command.run + ": " +
                    config::absence(before / "config.resolved.yaml",
                                    "is no run directory, it holds no config.resolved.yaml; give "
                                    "the folder that a run has written")};
  }
  if (command.verify) (void)expectedDigests(before);
  warnOfRunFiles(before.string());
  run::SystemOptions options{
      (before / "config.resolved.yaml").string(), {}, invocation.plugin_paths};
  options.quiet = invocation.quiet;
  auto checked = run::require(run::checkSystem(options));
  run::RunLog log(invocation.quiet);
  const run::SteadyClock clock;
  run::RunOptions run_options;
  run_options.out = out;
  run_options.replace = command.replace;
  run_options.command_line = invocation.command_line;
  run_options.exit_code = [](const run::Outcome& o) { return static_cast<int>(exitCode(o)); };
  run::Run run(log, clock, interrupts, run_options);
  const ExitGuard guard;
  const run::Outcome outcome = run.execute(std::move(checked));
  const bool is_whole = !outcome.interrupted && !outcome.failure;
  if (!command.verify || !is_whole) return show(outcome, before, invocation);
  return compare(before, out, invocation);
}

}  // namespace

void addRerunCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("rerun", "Run the configuration of a run again");
  auto options = std::make_shared<RerunCommand>();
  command->add_option("run", options->run, "Run directory")->type_name("RUN")->required();
  command->add_option("--out", options->out, "Directory of the new run (default: RUN-again)")
      ->type_name("FOLDER")
      ->check(notEmpty);
  addForce(*command, options->replace, "Replace the run that the --out directory holds");
  command->add_flag("--verify", options->verify,
                    "Compare the results byte for byte, and tell what has changed");
  command->callback(
      [options, &invocation] { invocation.exit_code = execute(*options, invocation); });
}

}  // namespace tolman::app
