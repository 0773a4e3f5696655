// SPDX-License-Identifier: BSD-3-Clause
// tolman sweep: many runs from one file.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <thread>

#include "app/duration_text.hpp"
#include "app/output_files.hpp"
#include "app/path_kind.hpp"
#include "app/sweep_display.hpp"
#include "app/system_options.hpp"
#include "app/terminal_output.hpp"
#include "config/paths.hpp"
#include "engine/terminal.hpp"
#include "experiment/job_files.hpp"
#include "experiment/point_run.hpp"
#include "experiment/run_table.hpp"
#include "experiment/sweep_archive.hpp"
#include "host/child_process.hpp"
#include "host/scratch_folder.hpp"
#include "record/atomic_file.hpp"
#include "record/data_files.hpp"
#include "record/output_places.hpp"

namespace tolman::app {
namespace {

using experiment::PlannedRun;
using experiment::PointState;
namespace fs = std::filesystem;

struct SweepCommand {
  std::string file;
  std::string out;
  std::size_t jobs = 0;
  bool dry_run = false;
  bool retry = false;
  bool replace = false;
  std::string write;
};

/// State of the runs of a plan.
struct SweepProgress {
  std::vector<PlannedRun> todo;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t lost = 0;     ///< runs of `done` that lost tracking
  std::size_t sharing = 0;  ///< runs in `todo` that take the answers of another run
  std::size_t others = 0;   ///< runs in the folder that the file no longer lists
  double run_s = 0;         ///< mean duration of the runs that are done; 0 if none is
};

SweepProgress progressOf(const experiment::Plan& plan, const fs::path& out, bool retry) {
  SweepProgress progress;
  std::vector<std::string> folders;
  double sum = 0;
  for (const PlannedRun& run : plan.runs) {
    folders.push_back(run.folder);
    const auto outcome = experiment::outcomeOf(out / run.folder);
    if (outcome.state == PointState::Done) {
      ++progress.done;
      if (outcome.lostTracking()) ++progress.lost;
      sum += outcome.wall_s;
    } else if (outcome.state == PointState::Failed && !retry) {
      ++progress.failed;
    } else {
      progress.todo.push_back(run);
      if (!run.front_end_folder.empty() || !run.answers_folder.empty()) ++progress.sharing;
    }
  }
  if (progress.done > 0) progress.run_s = sum / static_cast<double>(progress.done);
  std::ranges::sort(folders);
  const experiment::FrozenRuns frozen = experiment::frozenRuns(out);
  for (const auto* runs : {&frozen.planned, &frozen.earlier}) {
    for (const PlannedRun& run : *runs) {
      if (!std::ranges::binary_search(folders, run.folder)) ++progress.others;
    }
  }
  return progress;
}

experiment::Plan planOf(const SweepCommand& command, const fs::path& out,
                        const Invocation& invocation) {
  experiment::PlanOptions options;
  options.plugin_paths = invocation.plugin_paths;
  options.out = out;
  options.known = experiment::readKnownData(out);
  options.find_config = configFile;
  options.find_shipped = shippedConfig;
  options.environment = config::processEnvironment();
  experiment::Plan plan = experiment::makePlan(configFile(command.file), options);
  if (plan.problems.empty()) return plan;
  throw Ended{ExitCode::Configuration, config::format(plan.problems)};
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
                      {"answers_of",
                       run.front_end_folder.empty() ? run.answers_folder : run.front_end_folder}});
    }
    std::cout << jsonText(runs);
    return;
  }
  if (invocation.quiet) return;
  const auto fronts = std::ranges::count_if(plan.runs, &PlannedRun::is_front_end);
  const auto line = [](const char* name, const std::string& text) {
    std::cout << fmt::format("{:<10}{}\n", name, text);
  };
  line("sweep",
       fmt::format("{}: {} runs{}", plan.name, plan.runs.size() - static_cast<std::size_t>(fronts),
                   fronts > 0 ? fmt::format(", after {} that they need", fronts) : ""));
  line("folder", out.string());
  line("done", std::to_string(progress.done));
  if (progress.lost > 0) line("lost", fmt::format("tracking in {} of them", progress.lost));
  if (progress.failed > 0) line("failed", fmt::format("{} (--retry)", progress.failed));
  line("to do", std::to_string(progress.todo.size()));
  if (progress.sharing > 0) {
    line("shared",
         fmt::format("{} of them take the answers of another run's front end, where there "
                     "are images",
                     progress.sharing));
  }
  if (progress.others > 0) {
    line("left", fmt::format("{} runs in the folder are not in the file; they stay as they are",
                             progress.others));
  }
  const auto jobs = static_cast<double>(std::max<std::size_t>(command.jobs, 1));
  const double seconds = progress.run_s * static_cast<double>(progress.todo.size()) / jobs;
  if (!progress.todo.empty()) {
    line("time", seconds > 0
                     ? fmt::format("about {} with {} at a time, from the runs that are done",
                                   durationText(seconds), command.jobs)
                     : std::string("not known before a run is done"));
  }
  for (const std::string& path : plan.missing) {
    std::cout << fmt::format("warning   {} does not exist: the runs that read it will fail\n",
                             run::printable(path));
  }
  if (!command.dry_run) return;
  for (const PlannedRun& run : progress.todo) std::cout << "  " << run::printable(run.name) << "\n";
}

/// The command that runs one point, without its folder.
std::vector<std::string> pointCommand(const std::string& program, std::size_t jobs, bool retry,
                                      const Invocation& invocation) {
  std::vector<std::string> words = {program};
  for (const std::string& path : invocation.plugin_paths) {
    words.insert(words.end(), {"--plugin-path", fs::absolute(path).string()});
  }
  words.insert(words.end(), {"--quiet", "sweep", "point"});
  if (retry) words.emplace_back("--retry");
  if (jobs > 0) {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    words.insert(words.end(),
                 {"--threads", std::to_string(std::max<std::size_t>(1, cores / jobs))});
  }
  return words;
}

ExitCode runJobs(const SweepCommand& command, const SweepProgress& progress, const fs::path& out,
                 const Invocation& invocation) {
  const run::Interrupts interrupts;
  const auto words = pointCommand("/proc/self/exe", command.jobs, command.retry, invocation);
  experiment::JobsState state;
  {
    SweepDisplay display(std::cerr, terminalOf(invocation));
    state = experiment::runLocally(out, progress.todo, {command.jobs, words}, interrupts, display);
  }
  if (interrupts.requested()) return ExitCode::Interrupted;
  if (!invocation.quiet && !invocation.json) {
    std::cout << fmt::format("{:<10}{}\n", "ended",
                             jobsText(state) + ", in " + durationText(state.seconds));
  }
  if (state.failed + progress.failed > 0) return ExitCode::PluginFailed;
  return state.lost + progress.lost > 0 ? ExitCode::TrackingLost : ExitCode::Ok;
}

/// Refuses a folder of the sweep in data that its runs read: the data would change with every run.
void refuseInsideData(const experiment::Plan& plan, const fs::path& out) {
  for (const auto& [path, digest] : plan.data) {
    if (!record::isInside(out, path)) continue;
    throw Ended{ExitCode::Record, out.string() + ": lies in data that the runs read (" + path +
                                      ") and would change them; choose another --out"};
  }
}

/// Refuses the folder of a run: a sweep has one of its own.
void refuseRun(const fs::path& out) {
  for (const char* file : {"run.json", "run.sqlite", "point.json"}) {
    std::error_code ignored;
    if (!fs::exists(out / file, ignored)) continue;
    throw Ended{ExitCode::Record, fmt::format("{}: holds a run ({}), and no sweep; choose another "
                                              "--out, a new folder or that of this sweep",
                                              out.string(), file)};
  }
}

/// The files beside the runs. In the folder of a sweep they are Tolman's own.
std::vector<fs::path> filesBeside(const std::string& write, const fs::path& out) {
  std::vector<fs::path> files{out / "points.txt", out / "data.json"};
  for (const std::string& name : experiment::jobFileNames(write)) files.push_back(out / name);
  return files;
}

ExitCode execute(SweepCommand command, const Invocation& invocation) {
  if (command.file.empty()) throw CLI::RequiredError("a sweep file");
  requireKind(configFile(command.file), {PathKind::SweepFile}, "the file of a sweep",
              ExitCode::Configuration);
  if (command.jobs == 0) command.jobs = std::max(1U, std::thread::hardware_concurrency());
  const fs::path out =
      fs::absolute(command.out.empty() ? fs::path("sweeps") / fs::path(command.file).stem()
                                       : fs::path(command.out))
          .lexically_normal();
  refuseRun(out);
  requireOrEnd(record::refuseRunPlaces(out, "--out"));
  requireOrEnd(record::refuseFolders(filesBeside(command.write, out), "--out"));
  const experiment::FrozenRuns frozen = experiment::frozenRuns(out);
  if (frozen.planned.empty() && frozen.earlier.empty()) {
    refuseExisting(filesBeside(command.write, out), command.replace, "--out");
  }
  const experiment::Plan plan = planOf(command, out, invocation);
  refuseInsideData(plan, out);
  const SweepProgress progress = progressOf(plan, out, command.retry);
  printPlan(plan, progress, command, out, invocation);
  if (command.dry_run) return ExitCode::Ok;
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw Ended{ExitCode::Record, out.string() + ": " + error.message()};
  const record::FileDescriptor lock = record::lockFolder(out);
  if (!lock.isOpen()) {
    throw Ended{
        ExitCode::Record,
        out.string() + ": " +
            config::absence(out,
                            "another sweep works here; wait for its end, or choose another --out")};
  }
  for (const PlannedRun& run : progress.todo) requireOrEnd(experiment::freeze(out, run));
  requireOrEnd(experiment::writePlanOrder(out, plan.runs));
  requireOrEnd(experiment::writeKnownData(out, plan.data));
  if (command.write.empty()) return runJobs(command, progress, out, invocation);
  const std::string program = fs::read_symlink("/proc/self/exe", error).string();
  const auto written =
      experiment::writeJobFiles(out, plan.name, progress.todo,
                                pointCommand(program, 0, command.retry, invocation), command.write);
  printFiles(valueOrEnd(written), invocation);
  return ExitCode::Ok;
}

void requireSweep(const std::string& folder, ExitCode code, std::vector<PathKind> accepted = {}) {
  accepted.insert(accepted.end(), {PathKind::Sweep, PathKind::Folder});
  requireKind(folder, accepted, "the folder of a sweep", code);
}

void addPoint(CLI::App& sweep, Invocation& invocation) {
  CLI::App* command = sweep.add_subcommand("point", "Run one frozen run of a sweep");
  auto folder = std::make_shared<std::string>();
  auto options = std::make_shared<experiment::PointRunOptions>();
  command->add_option("run", *folder, "Its folder")->type_name("FOLDER")->required();
  command->add_flag("--retry", options->retry, "Run it again when it has failed");
  command->add_option("--threads", options->threads, "Threads, where the configuration has 0")
      ->check(CLI::Range(1, 1024));
  command->callback([folder, options, &invocation] {
    requireKind(*folder, {PathKind::Point, PathKind::Folder}, "the folder of one run of a sweep",
                ExitCode::Configuration);
    const run::Interrupts interrupts;
    options->plugin_paths = invocation.plugin_paths;
    options->command_line = invocation.command_line;
    options->quiet = invocation.quiet;
    options->find_config = configFile;
    options->exit_code = [](const run::Outcome& o) { return static_cast<int>(exitCode(o)); };
    options->failure_code = [](const run::Failure& f) {
      return static_cast<int>(exitCode(f.kind));
    };
    const auto outcome = experiment::runPoint(*folder, *options, interrupts);
    if (!outcome.message.empty()) std::cerr << run::printable(outcome.message) << "\n";
    invocation.exit_code = static_cast<ExitCode>(outcome.exit_code);
    if (outcome.state == PointState::Interrupted) invocation.exit_code = ExitCode::Interrupted;
    // Its files are damaged, exchanged, or of another run, whatever it ended with.
    const bool is_damaged = outcome.state == PointState::Failed && outcome.exit_code == 0;
    if (is_damaged) invocation.exit_code = ExitCode::PluginFailed;
  });
}

void addStatus(CLI::App& sweep, Invocation& invocation) {
  CLI::App* command =
      sweep.add_subcommand("status", "What became of the runs of a sweep, from their folders");
  auto folder = std::make_shared<std::string>();
  command->add_option("sweep", *folder, "Folder of the sweep")->type_name("FOLDER")->required();
  command->callback([folder, &invocation] {
    requireSweep(*folder, ExitCode::Usage);
    const experiment::FrozenRuns runs = experiment::frozenRuns(*folder);
    if (runs.empty()) {
      throw Ended{ExitCode::Usage,
                  *folder + ": " + config::absence(*folder, "holds no runs of a sweep")};
    }
    std::map<PointState, int> counts;
    int lost = 0;
    auto list = nlohmann::ordered_json::array();
    std::string failed;
    for (const PlannedRun& run : runs.planned) {
      const auto outcome = experiment::outcomeOf(fs::path(*folder) / run.folder);
      ++counts[outcome.state];
      list.push_back({{"name", run.name},
                      {"folder", run.folder},
                      {"state", enumName(outcome.state)},
                      {"exit_code", outcome.exit_code},
                      {"message", outcome.message},
                      {"wall_s", outcome.wall_s}});
      if (outcome.lostTracking()) ++lost;
      if (outcome.message.empty() && !outcome.lostTracking()) continue;
      failed += run::printable("  " + run.name + "\n    " + outcome.message) + "\n";
    }
    for (const std::string& missing : runs.missing) {
      list.push_back({{"name", ""}, {"folder", missing}, {"state", "missing"}});
    }
    if (invocation.json) {
      std::cout << jsonText(list);
      return;
    }
    for (const auto& [state, count] : counts) {
      std::cout << fmt::format("{:<13}{}\n", enumName(state), count);
    }
    if (lost > 0)
      std::cout << fmt::format("{:<13}tracking in {} of those that are done\n", "lost", lost);
    if (!runs.missing.empty()) {
      std::cout << fmt::format("{:<13}{} without a readable point.json\n", "missing",
                               runs.missing.size());
      for (const std::string& run : runs.missing) failed += run::printable("  " + run) + "\n";
    }
    if (!runs.earlier.empty()) {
      std::cout << fmt::format("{:<13}{} of earlier plans\n", "not counted", runs.earlier.size());
    }
    std::cout << failed;
  });
}

/// Warns of runs that failed or are not done: what is written is without them.
void warnOfUnfinished(const fs::path& sweep) {
  const std::string text = experiment::unfinishedText(sweep);
  if (!text.empty()) std::cerr << "warning: " + run::printable(text) + "\n";
}

void addCollect(CLI::App& sweep, Invocation& invocation) {
  CLI::App* command =
      sweep.add_subcommand("collect", "Factors and metrics of the runs that are done, as CSV");
  auto folder = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto metrics = std::make_shared<std::vector<std::string>>();
  command->add_option("sweep", *folder, "Folder of the sweep")->type_name("FOLDER")->required();
  command
      ->add_option("--metric", *metrics, "Only this key of metrics.json (repeatable; default: all)")
      ->type_name("KEY")
      ->allow_extra_args(false);
  command->add_option("--out", *out, "File (default: results.csv in the sweep)")
      ->type_name("FILE")
      ->check(notEmpty);
  auto replace = std::make_shared<bool>(false);
  addForce(*command, *replace, "Replace the file of --out");
  command->callback([folder, out, metrics, replace, &invocation] {
    if (!out->empty()) refuseExisting({*out}, *replace, "--out");
    requireSweep(*folder, ExitCode::Dataset, {PathKind::Run, PathKind::Table});
    const auto rows = valueOrEnd(experiment::readRunRows({*folder}));
    warnOfUnfinished(*folder);
    if (rows.empty()) throw Ended{ExitCode::Dataset, *folder + ": no run is done"};
    const fs::path file = out->empty() ? fs::path(*folder) / "results.csv" : fs::path(*out);
    requireOrEnd(record::writeOutput(file, experiment::csvOf(rows, *metrics)));
    printFiles({file}, invocation);
  });
}

/// Whether the file is an archive that was written of a sweep with this name.
bool isArchiveOf(const fs::path& file, const fs::path& name) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  isolation::ChildProcess tar({"/bin/sh", "-c", "exec tar -tzf \"$1\" \"$2\" >/dev/null 2>&1", "sh",
                               file.string(), (name / "rerun.sh").string()},
                              {});
  const isolation::ProcessEnd end = tar.end(std::chrono::hours(1));
  return end.signal == 0 && end.exit_code == 0;
}

void addArchive(CLI::App& sweep, Invocation& invocation) {
  CLI::App* command = sweep.add_subcommand(
      "archive", "Configurations, digests, results and commands, to run it again elsewhere");
  auto folder = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  command->add_option("sweep", *folder, "Folder of the sweep")->type_name("FOLDER")->required();
  command->add_option("--out", *out, "Archive to write (default: SWEEP.tar.gz)")
      ->type_name("FILE")
      ->check(notEmpty);
  auto replace = std::make_shared<bool>(false);
  addForce(*command, *replace, "Replace the file, whatever it is");
  command->callback([folder, out, replace, &invocation] {
    fs::path from = fs::absolute(*folder).lexically_normal();
    if (!from.has_filename()) from = from.parent_path();
    const fs::path file = fs::absolute(out->empty() ? from.string() + ".tar.gz" : *out);
    const fs::path name = from.filename();
    const auto is_archive = [&](const fs::path& found) { return isArchiveOf(found, name); };
    requireSweep(*folder, ExitCode::Dataset);
    if (experiment::frozenRuns(from).empty()) {
      throw Ended{ExitCode::Dataset,
                  *folder + ": " + config::absence(*folder, "holds no runs of a sweep")};
    }
    refuseExisting({file}, *replace, "--out", is_archive);
    warnOfUnfinished(from);
    const host::ScratchFolder files("tolman-archive");
    if (files.path().empty()) throw Ended{ExitCode::Record, host::kNoScratchFolder};
    requireOrEnd(experiment::writeSweepArchive(from, files.path() / name));
    const fs::path partial = file.string() + ".partial";
    isolation::ChildProcess tar(
        {"/usr/bin/env", "tar", "--sort=name", "--owner=0", "--group=0", "--mtime=@0", "-C",
         files.path().string(), "-czf", partial.string(), name.string()},
        {});
    const isolation::ProcessEnd end = tar.end(std::chrono::hours(24));
    std::error_code error;
    if (end.signal == 0 && end.exit_code == 0) fs::rename(partial, file, error);
    if (end.signal != 0 || end.exit_code != 0 || error) {
      std::error_code ignored;
      fs::remove(partial, ignored);
      throw Ended{ExitCode::Record, file.string() + ": not written (" +
                                        (error ? error.message() : "tar " + end.text()) + ")"};
    }
    printFiles({file}, invocation);
  });
}

}  // namespace

void addSweepCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("sweep", "Many runs from one file: grids, samples, seeds");
  auto options = std::make_shared<SweepCommand>();
  command->add_option("file", options->file, "What varies (YAML)")->type_name("FILE");
  command->add_option("--out", options->out, "Folder of the sweep (default: sweeps/FILE)")
      ->type_name("FOLDER")
      ->check(notEmpty);
  command->add_option("--jobs", options->jobs, "Runs at a time (default: one per processor)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--dry-run", options->dry_run, "Check all runs and print what is to do");
  command->add_flag("--retry", options->retry, "Run those that failed again");
  addForce(*command, options->replace, "Replace files of other programs in the folder");
  command
      ->add_option("--write", options->write,
                   "Freeze the runs and write what others run them with, instead of running them")
      ->type_name("slurm|parallel|snakemake")
      ->check(CLI::IsMember({"slurm", "parallel", "snakemake"}));
  addStatus(*command, invocation);
  addCollect(*command, invocation);
  addArchive(*command, invocation);
  addPoint(*command, invocation);
  command->callback([command, options, &invocation] {
    if (!command->get_subcommands().empty()) return;  // the subcommand has run already
    invocation.exit_code = execute(*options, invocation);
  });
}

}  // namespace tolman::app
