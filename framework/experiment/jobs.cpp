// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "experiment/sweep_folder.hpp"
#include "host/child_process.hpp"
#include "record/atomic_file.hpp"

namespace tolman::experiment {
namespace {

namespace fs = std::filesystem;

/// The text as one word of a shell.
std::string shellWord(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

class JobFiles {
 public:
  JobFiles(fs::path sweep, std::string name, const std::vector<PlannedRun>& runs,
           const std::vector<std::string>& command)
      : sweep_(std::move(sweep)), name_(shellWord(name)) {
    for (const std::string& word : command) {
      command_ += (command_.empty() ? "" : " ") + shellWord(word);
    }
    const auto is_to_do = [&](const std::string& folder) {
      return !folder.empty() && std::ranges::find(runs, folder, &PlannedRun::folder) != runs.end();
    };
    for (const PlannedRun& run : runs) {
      const bool waits = is_to_do(run.front_end_folder) || is_to_do(run.answers_folder);
      lists_.at(waits ? 1 : 0).push_back(run);
    }
  }

  void slurm() {
    write("array.sh",
          fmt::format("#!/bin/sh\n# One task of a Slurm array: the run in line SLURM_ARRAY_TASK_ID "
                      "of the list.\n"
                      "folder=$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" \"$1\")\n"
                      "exec {} \"$folder\"\n",
                      command_));
    std::string submit =
        "#!/bin/sh\n# Submits the runs and ends; options are passed on to sbatch, such as\n"
        "#   sh submit.sh --time=10 --cpus-per-task=2\n"
        "# `tolman sweep status` reads what became of them.\nset -e\n"
        "here=$(cd \"$(dirname \"$0\")\" && pwd)\nafter=\n";
    for (const std::size_t i : {0, 1}) {
      write(fmt::format("runs-{}.txt", i + 1), lines(i, [](const std::string& f) { return f; }));
      if (lists_.at(i).empty()) continue;
      submit += fmt::format(
          "id=$(sbatch --parsable --job-name={} --array=1-{} --output=/dev/null $after \"$@\" "
          "\"$here/array.sh\" \"$here/runs-{}.txt\")\n"
          "echo \"$id\"\nafter=--dependency=afterany:${{id%%;*}}\n",
          name_, lists_.at(i).size(), i + 1);
    }
    write("submit.sh", submit);
  }

  void parallel() {
    for (const std::size_t i : {0, 1}) {
      write(fmt::format("commands-{}.txt", i + 1), lines(i, [&](const std::string& folder) {
              return command_ + " " + shellWord(folder);
            }));
    }
  }

  void snakemake() {
    std::string text =
        "# Runs of the sweep: snakemake --cores 4 --keep-going\n"
        "import os\nHERE = workflow.basedir\nTAKES = {\n";
    for (const std::size_t i : {0, 1}) {
      for (const PlannedRun& run : lists_.at(i)) {
        const std::string& front =
            run.front_end_folder.empty() ? run.answers_folder : run.front_end_folder;
        text += fmt::format("    \"{}\": \"{}\",\n", run.folder, i == 0 ? "" : front);
        std::error_code ignored;
        fs::remove(sweep_ / run.folder / "ended", ignored);  // of an earlier attempt
      }
    }
    // A failed run counts as ended: runs that wait for its answers then run their own front end.
    text += fmt::format(
        "}}\n\nrule all:\n    input: [f\"{{HERE}}/{{run}}/ended\" for run in TAKES]\n"
        "    params: here=HERE\n"
        "    shell: r\"\"\"test -z \"$(find {{params.here:q}} -maxdepth 2 -name outcome.json "
        "-exec grep -l '\"state\": \"failed\"' {{{{}}}} +)\" "
        "|| {{{{ echo 'some runs have failed: tolman sweep status' >&2; exit 1; }}}}\"\"\"\n\n"
        "rule point:\n"
        "    input: lambda w: [f\"{{HERE}}/{{TAKES[w.run]}}/ended\"] if TAKES[w.run] else []\n"
        "    output: touch(HERE + \"/{{run}}/ended\")\n"
        "    params: folder=lambda w: f\"{{HERE}}/{{w.run}}\"\n"
        "    shell: r\"\"\"{} {{params.folder:q}} || test -e "
        "{{params.folder:q}}/outcome.json\"\"\"\n",
        command_);
    write("Snakefile", text);
  }

  Result<std::vector<fs::path>> result() const {
    if (!status_.isOk()) return status_;
    return written_;
  }

 private:
  /// One line for each run of list i.
  template <class Line>
  std::string lines(std::size_t i, const Line& line) const {
    std::string text;
    for (const PlannedRun& run : lists_.at(i)) text += line((sweep_ / run.folder).string()) + "\n";
    return text;
  }

  void write(const std::string& file, const std::string& text) {
    if (!status_.isOk()) return;
    status_ = record::writeAtomically(sweep_ / file, text);
    written_.push_back(sweep_ / file);
  }

  fs::path sweep_;
  std::string name_;
  std::string command_;
  std::array<std::vector<PlannedRun>, 2> lists_;  ///< those of the second after the first
  std::vector<fs::path> written_;
  Status status_;
};

/// Runs the processes of runLocally().
class Jobs {
 public:
  Jobs(const fs::path& sweep, const std::vector<PlannedRun>& runs, const LocalJobsOptions& options,
       const Cancellation& cancellation)
      : sweep_(sweep), options_(options), cancellation_(cancellation) {
    state_.all = runs.size();
    for (const PlannedRun& run : runs) {
      waiting_.insert(run.folder);
      todo_.push_back(&run);
    }
  }

  JobsState run() {
    constexpr std::chrono::milliseconds kPoll(20);
    bool interrupted = false;  // the processes have been
    while (!running_.empty() || (!todo_.empty() && !stopping())) {
      if (!stopping()) startReady();
      if (stopping() && !std::exchange(interrupted, true)) {
        for (const Job& job : running_) job.process->signal(SIGINT);
      }
      std::this_thread::sleep_for(kPoll);
      std::erase_if(running_, [&](const Job& job) {
        if (!job.process->hasEnded()) return false;
        end(*job.run, outcomeOfJob(job));
        return true;
      });
      show();
    }
    return state_;
  }

 private:
  struct Job {
    const PlannedRun* run;
    std::unique_ptr<host::ChildProcess> process;
  };

  bool stopping() const { return cancellation_.requested(); }

  /// Starts runs whose answers or maps to build on have ended.
  void startReady() {
    for (auto next = todo_.begin(); next != todo_.end() && running_.size() < options_.jobs;) {
      const PlannedRun& run = **next;
      const bool waits =
          waiting_.contains(run.front_end_folder) || waiting_.contains(run.answers_folder);
      next = waits ? next + 1 : todo_.erase(next);
      if (!waits) start(run);
    }
  }

  void start(const PlannedRun& run) {
    const std::string folder = (sweep_ / run.folder).string();
    std::vector<std::string> words = options_.command;
    words.push_back(folder);
    const record::FileDescriptor output(
        ::open((folder + "/output.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    try {
      running_.push_back({&run, std::make_unique<host::ChildProcess>(
                                    words, std::vector<int>(),
                                    output.isOpen() ? output.number() : STDERR_FILENO)});
    } catch (const std::system_error& error) {
      constexpr int kNoProcess = 70;
      end(run, {PointState::Failed, kNoProcess, error.what()});
    }
  }

  /// The outcome that the process has written, or one from how it ended.
  PointOutcome outcomeOfJob(const Job& job) const {
    constexpr int kSignalOffset = 128;  // of a shell
    const fs::path folder = sweep_ / job.run->folder;
    PointOutcome outcome = outcomeOf(folder);
    if (outcome.state == PointState::Done || outcome.state == PointState::Failed) return outcome;
    if (stopping()) return {PointState::Interrupted};
    const host::ProcessEnd end = job.process->end(std::chrono::milliseconds(0));
    outcome = {PointState::Failed, end.signal > 0 ? kSignalOffset + end.signal : end.exit_code,
               "the process " + end.text() + "; see " + (folder / "output.txt").string()};
    const Status written = writeOutcome(folder, outcome);
    if (!written.isOk()) outcome.message += "; " + written.message();
    return outcome;
  }

  void end(const PlannedRun& run, const PointOutcome& outcome) {
    waiting_.erase(run.folder);
    if (outcome.state == PointState::Interrupted) return;
    ++state_.ended;
    if (outcome.state != PointState::Done) ++state_.failed;
    if (outcome.lostTracking()) ++state_.lost;
    options_.on_end(run, outcome, state_);
  }

  void show() {
    const auto now = std::chrono::steady_clock::now();
    state_.seconds = std::chrono::duration<double>(now - begin_).count();
    state_.running.clear();
    for (const Job& job : running_) state_.running.push_back(job.run->name);
    options_.on_state(state_);
  }

  fs::path sweep_;
  const LocalJobsOptions& options_;
  const Cancellation& cancellation_;
  std::vector<const PlannedRun*> todo_;
  std::set<std::string> waiting_;  ///< folders of runs that have not ended
  std::vector<Job> running_;
  JobsState state_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

Result<std::vector<fs::path>> writeJobFiles(const fs::path& sweep, const std::string& name,
                                            const std::vector<PlannedRun>& runs,
                                            const std::vector<std::string>& command,
                                            const std::string& kind) {
  JobFiles files(sweep, name, runs, command);
  if (kind == "slurm") files.slurm();
  if (kind == "parallel") files.parallel();
  if (kind == "snakemake") files.snakemake();
  return files.result();
}

JobsState runLocally(const fs::path& sweep, const std::vector<PlannedRun>& runs,
                     const LocalJobsOptions& options, const Cancellation& cancellation) {
  return Jobs(sweep, runs, options, cancellation).run();
}

}  // namespace tolman::experiment
