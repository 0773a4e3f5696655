// SPDX-License-Identifier: BSD-3-Clause
// tolman sweep: many runs from one file; and status, collect and point, on its folder.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <iostream>
#include <thread>

#include "app/options.hpp"
#include "app/program.hpp"
#include "config/text.hpp"
#include "config/values.hpp"
#include "experiment/comparison.hpp"
#include "experiment/sweep_folder.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

using experiment::PlannedRun;
using experiment::PointState;
namespace fs = std::filesystem;

struct SweepCommand {
  std::string file;
  Output out;
  std::size_t jobs = 0;
  bool dry_run = false;
  bool retry = false;
  bool freeze = false;
};

/// "37 of 300, 2 failed, 1:05 left"
std::string jobsText(const experiment::JobsState& state) {
  std::string text = fmt::format("{} of {}", state.ended, state.all);
  if (state.failed > 0) text += fmt::format(", {} failed", state.failed);
  if (state.lost > 0) text += fmt::format(", {} lost tracking", state.lost);
  if (state.left_s >= 0 && state.ended < state.all) {
    text += ", " + durationText(state.left_s) + " left";
  }
  return text;
}

/// State of the runs of a plan.
struct SweepProgress {
  std::vector<PlannedRun> todo;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t lost = 0;  ///< runs of `done` that lost tracking
};

SweepProgress progressOf(const experiment::Plan& plan, const fs::path& out, bool retry) {
  SweepProgress progress;
  for (const PlannedRun& run : plan.runs) {
    const auto outcome = experiment::outcomeOf(out / run.folder);
    if (outcome.state == PointState::Done) {
      ++progress.done;
      if (outcome.lostTracking()) ++progress.lost;
    } else if (outcome.state == PointState::Failed && !retry) {
      ++progress.failed;
    } else {
      progress.todo.push_back(run);
    }
  }
  return progress;
}

experiment::Plan planOf(const SweepCommand& command, const experiment::FrozenRuns& frozen,
                        const fs::path& out, const Invocation& invocation) {
  experiment::PlanOptions options;
  options.plugin_paths = invocation.plugin_paths;
  options.out = out;
  options.frozen = frozen;
  options.find_config = configFile;
  options.find_shipped = shippedConfig;
  options.environment = config::processEnvironment();
  experiment::Plan plan = experiment::makePlan(configFile(command.file), options);
  if (plan.problems.empty()) return plan;
  fail(ExitCode::Configuration, config::format(plan.problems));
}

void printPlan(const experiment::Plan& plan, const SweepProgress& progress,
               const SweepCommand& command, const fs::path& out, const Invocation& invocation) {
  if (invocation.json) {
    auto runs = nlohmann::ordered_json::array();
    for (const PlannedRun& run : plan.runs) {
      runs.push_back({{"name", run.name},
                      {"key", run.key},
                      {"folder", (out / run.folder).string()},
                      {"state", enumName(experiment::outcomeOf(out / run.folder).state)},
                      {"answers_of", run.needs()}});
    }
    std::cout << jsonText(runs);
    return;
  }
  if (invocation.quiet) return;
  const auto fronts = std::ranges::count_if(plan.runs, &PlannedRun::is_front_end);
  const std::size_t todo = progress.todo.size();
  std::string text =
      row("sweep",
          fmt::format("{}: {} runs{}", plan.name, std::ssize(plan.runs) - fronts,
                      fronts > 0 ? fmt::format(", after {} that they need", fronts) : "")) +
      row("folder", out.string()) + row("done", std::to_string(progress.done));
  const auto add = [&](std::size_t count, const char* name, const char* rest) {
    if (count > 0) text += row(name, std::to_string(count) + rest);
  };
  add(progress.lost, "lost", " of them lost tracking");
  add(progress.failed, "failed", " (--retry)");
  text += row("to do", std::to_string(todo));
  for (const std::string& path : plan.missing) {
    text += row("warning", path + " does not exist: the runs that read it will fail");
  }
  std::cout << text;
  if (!command.dry_run) return;
  for (const PlannedRun& run : progress.todo) std::cout << "  " << run.name << "\n";
}

/// The command that runs one point, without its folder.
std::vector<std::string> pointCommand(const std::string& program, std::size_t jobs,
                                      const Invocation& invocation) {
  std::vector<std::string> words = {program};
  for (const std::string& path : invocation.plugin_paths) {
    words.insert(words.end(), {"--plugin-path", fs::absolute(path).string()});
  }
  words.insert(words.end(), {"--quiet", "sweep", "point"});
  if (jobs > 0) {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    words.insert(words.end(),
                 {"--threads", std::to_string(std::max<std::size_t>(1, cores / jobs))});
  }
  return words;
}

/// Progress on stderr: on a terminal one line, otherwise one for each run that has ended.
ExitCode runJobs(const SweepCommand& command, const SweepProgress& progress, const fs::path& out,
                 const Invocation& invocation) {
  const engine::Interrupts interrupts;
  const Terminal terminal = terminalOf(invocation);
  experiment::JobsState state;
  {
    StatusLine line(std::cerr);
    double shown_s = -1;  // time of the last drawing
    const auto onState = [&](const experiment::JobsState& now) {
      constexpr double kRedraw = 0.2;  // s between two drawings
      if (!terminal.interactive || now.seconds - shown_s < kRedraw) return;
      shown_s = now.seconds;
      line.show(jobsText(now) + ": " + config::listed(now.running));
    };
    const auto onEnd = [&](const PlannedRun& run, const experiment::PointOutcome& outcome,
                           const experiment::JobsState& now) {
      const bool failed = outcome.state == PointState::Failed;
      if (!failed && (terminal.interactive || terminal.quiet)) return;
      line.add(fmt::format("{:<20} {:<7} {:7.1f} s  {}", jobsText(now), enumName(outcome.state),
                           outcome.wall_s, run.name) +
               (failed ? "\n    " + outcome.message : ""));
    };
    const auto words = pointCommand("/proc/self/exe", command.jobs, invocation);
    state = experiment::runLocally(out, progress.todo, {command.jobs, words, onState, onEnd},
                                   interrupts);
  }
  if (interrupts.requested()) return ExitCode::Interrupted;
  if (!invocation.quiet && !invocation.json) {
    std::cout << row("ended", jobsText(state) + ", in " + durationText(state.seconds));
  }
  if (state.failed + progress.failed > 0) return ExitCode::PluginFailed;
  return state.lost + progress.lost > 0 ? ExitCode::TrackingLost : ExitCode::Ok;
}

/// commands.txt: a line of a shell for each run, in any order or at the same time.
void writeCommands(const std::vector<PlannedRun>& runs, const fs::path& out,
                   const Invocation& invocation) {
  std::string lines;
  for (const PlannedRun& run : runs) {
    std::vector<std::string> words = pointCommand(thisProgram(), 0, invocation);
    words.push_back((out / run.folder).string());
    for (std::string& word : words) {
      boost::replace_all(word, "'", "'\\''");
      lines += "'" + word + (&word == &words.back() ? "'\n" : "' ");
    }
  }
  const fs::path file = out / "commands.txt";
  failUnless(record::writeAtomically(file, lines));
  printFiles({file}, invocation);
}

/// Refuses a folder of the sweep in data that its runs read: the data would change with every run.
void refuseInsideData(const experiment::Plan& plan, const fs::path& out) {
  for (const auto& [path, digest] : plan.data) {
    if (!record::isInside(out, path)) continue;
    fail(ExitCode::Record, out.string() + ": lies in data that the runs read (" + path +
                               ") and would change them; choose another --out");
  }
}

ExitCode execute(SweepCommand command, const Invocation& invocation) {
  if (command.file.empty()) throw CLI::RequiredError("a sweep file");
  if (command.jobs == 0) command.jobs = std::max(1U, std::thread::hardware_concurrency());
  const fs::path out =
      fs::absolute(command.out.path.empty() ? fs::path("sweeps") / fs::path(command.file).stem()
                                            : fs::path(command.out.path))
          .lexically_normal();
  const experiment::FrozenRuns frozen = experiment::frozenRuns(out);
  if (frozen.empty()) refuseExisting({out}, command.out.replace, "--out");
  const experiment::Plan plan = planOf(command, frozen, out, invocation);
  refuseInsideData(plan, out);
  const SweepProgress progress = progressOf(plan, out, command.retry);
  printPlan(plan, progress, command, out, invocation);
  if (command.dry_run) return ExitCode::Ok;
  std::error_code error;
  fs::create_directories(out, error);
  if (error) fail(ExitCode::Record, out.string() + ": " + error.message());
  const record::FileDescriptor lock = record::lockFolder(out);
  if (!lock.isOpen()) {
    fail(ExitCode::Record,
         out.string() + ": " +
             config::absence(
                 out, "another sweep works here; wait for its end, or choose another --out"));
  }
  failUnless(experiment::freeze(out, progress.todo, plan.runs));
  for (const PlannedRun& run : progress.todo) {  // failed ones are to be retried
    const fs::path folder = out / run.folder;
    if (experiment::outcomeOf(folder).state == PointState::Failed) {
      fs::remove(folder / "outcome.json", error);
    }
  }
  if (!command.freeze) return runJobs(command, progress, out, invocation);
  writeCommands(progress.todo, out, invocation);
  return ExitCode::Ok;
}

// Commands on the folder of a sweep.

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
}

void printStatus(const std::string& folder, const Invocation& invocation) {
  const experiment::FrozenRuns runs = experiment::frozenRuns(folder);
  if (runs.empty()) {
    fail(ExitCode::Usage, folder + ": " + config::absence(folder, "holds no runs of a sweep"));
  }
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
  const std::string unfinished = experiment::unfinishedText(command.sweep);
  if (!unfinished.empty()) std::cerr << "warning: " + unfinished + "\n";
  if (rows.empty()) fail(ExitCode::Dataset, command.sweep + ": no run is done");
  const fs::path file = out.empty() ? fs::path(command.sweep) / "results.csv" : fs::path(out);
  failUnless(
      record::writeOutput(file, experiment::csvOf(experiment::tableOf(rows, command.metrics))));
  printFiles({file}, invocation);
}

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

  CLI::App& point = *sweep.add_subcommand("point", "Run one frozen run of a sweep");
  auto folder = std::make_shared<std::string>();
  auto options = std::make_shared<experiment::PointRunOptions>();
  addArgument(point, "run", *folder, "FOLDER", "Its folder");
  addOption(point, "--threads", options->threads, "N", "Threads, where the configuration has 0")
      ->check(CLI::Range(1, 1024));
  point.callback([folder, options, &invocation] { runPoint(*folder, *options, invocation); });
}

}  // namespace

ExitCode runSweep(const fs::path& file, const fs::path& out, std::size_t jobs,
                  const Invocation& invocation) {
  SweepCommand command;
  command.file = file;
  command.out.path = out;
  command.jobs = jobs;
  return execute(command, invocation);
}

void addSweepCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("sweep", "Many runs from one file: grids, samples, seeds");
  auto options = std::make_shared<SweepCommand>();
  addOption(command, "file", options->file, "FILE", "What varies (YAML)");
  options->out.add(command, "FOLDER", "Folder of the sweep (default: sweeps/FILE)",
                   "Use a folder that holds other files");
  addOption(command, "--jobs", options->jobs, "N", "Runs at a time (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--dry-run", options->dry_run, "Check all runs and print what is to do");
  command.add_flag("--retry", options->retry, "Run those that failed again");
  command.add_flag("--freeze", options->freeze,
                   "Freeze the runs and write commands.txt, a line for each, instead of running");
  addSweepCommands(command, invocation);
  command.callback([&command, options, &invocation] {
    if (!command.get_subcommands().empty()) return;  // the subcommand has run already
    invocation.exit_code = execute(*options, invocation);
  });
}

}  // namespace tolman::app
