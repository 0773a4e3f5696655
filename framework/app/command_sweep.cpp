// SPDX-License-Identifier: BSD-3-Clause
// tolman sweep: many runs from one file.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <thread>

#include "app/options.hpp"
#include "app/progress_line.hpp"
#include "experiment/job_files.hpp"
#include "experiment/local_jobs.hpp"
#include "experiment/planner.hpp"
#include "experiment/sweep_archive.hpp"
#include "record/atomic_file.hpp"
#include "record/data_digest.hpp"

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
  std::string write;
};

/// "37 of 300, 2 failed, 1:05 left"
std::string jobsText(const experiment::JobsState& state) {
  std::string text = fmt::format("{} of {}", state.ended, state.all);
  if (state.failed > 0) text += fmt::format(", {} failed", state.failed);
  if (state.lost > 0) text += fmt::format(", {} lost tracking", state.lost);
  if (state.ended > 0 && state.ended < state.all) {
    const double left = state.seconds / static_cast<double>(state.ended) *
                        static_cast<double>(state.all - state.ended);
    text += ", " + durationText(left) + " left";
  }
  return text;
}

/// Progress on stderr: on a terminal a table that is redrawn, otherwise a line for each run that
/// has ended.
class SweepDisplay : public experiment::JobsListener {
 public:
  explicit SweepDisplay(Terminal terminal) : terminal_(terminal) {}
  ~SweepDisplay() override { wipe(); }
  SweepDisplay(const SweepDisplay&) = delete;
  SweepDisplay& operator=(const SweepDisplay&) = delete;

  void onState(const experiment::JobsState& state) override {
    constexpr double kRedraw = 0.2;       // s between two drawings
    constexpr std::size_t kColumns = 78;  // most characters of a run's name
    if (!terminal_.interactive || state.seconds - shown_s_ < kRedraw) return;
    shown_s_ = state.seconds;
    wipe();
    std::string text = jobsText(state) + "\n";
    for (const std::string& name : state.running) text += "  " + name.substr(0, kColumns) + "\n";
    std::cerr << text << std::flush;
    drawn_ = 1 + state.running.size();
  }

  void onEnd(const PlannedRun& run, const experiment::PointOutcome& outcome,
             const experiment::JobsState& state) override {
    const bool failed = outcome.state == PointState::Failed;
    if (!failed && (terminal_.interactive || terminal_.quiet)) return;
    wipe();
    shown_s_ = -1;
    std::cerr << fmt::format("{:<20} {:<7} {:7.1f} s  {}\n", jobsText(state),
                             enumName(outcome.state), outcome.wall_s, run.name);
    if (failed) std::cerr << "    " << outcome.message << "\n";
  }

 private:
  void wipe() {
    for (; drawn_ > 0; --drawn_) std::cerr << "\x1b[1A\x1b[2K";
  }

  Terminal terminal_;
  std::size_t drawn_ = 0;  ///< lines of the table on the terminal
  double shown_s_ = -1;    ///< time of the last drawing
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
                             path);
  }
  if (!command.dry_run) return;
  for (const PlannedRun& run : progress.todo) std::cout << "  " << run.name << "\n";
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
  const engine::Interrupts interrupts;
  const auto words = pointCommand("/proc/self/exe", command.jobs, command.retry, invocation);
  experiment::JobsState state;
  {
    SweepDisplay display(terminalOf(invocation));
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
  if (experiment::frozenRuns(out).empty()) refuseExisting({out}, command.out.replace, "--out");
  const experiment::Plan plan = planOf(command, out, invocation);
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
  for (const PlannedRun& run : progress.todo) failUnless(experiment::freeze(out, run));
  failUnless(experiment::writePlanOrder(out, plan.runs));
  failUnless(experiment::writeKnownData(out, plan.data));
  if (command.write.empty()) return runJobs(command, progress, out, invocation);
  const std::string program = fs::read_symlink("/proc/self/exe", error).string();
  const auto written =
      experiment::writeJobFiles(out, plan.name, progress.todo,
                                pointCommand(program, 0, command.retry, invocation), command.write);
  printFiles(valueOf(written), invocation);
  return ExitCode::Ok;
}

}  // namespace

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
  addChoice(command, "--write", options->write, {"slurm", "parallel", "snakemake"},
            "Freeze the runs and write what others run them with, instead of running them");
  addSweepCommands(command, invocation);
  command.callback([&command, options, &invocation] {
    if (!command.get_subcommands().empty()) return;  // the subcommand has run already
    invocation.exit_code = execute(*options, invocation);
  });
}

}  // namespace tolman::app
