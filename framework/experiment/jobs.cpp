// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <chrono>
#include <memory>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "base/text_file.hpp"
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
  JobFiles(fs::path sweep, const std::string& name, const std::vector<PlannedRun>& runs,
           const std::vector<std::string>& command, const FindConfig& find_config)
      : sweep_(std::move(sweep)), name_(shellWord(name)), find_config_(find_config) {
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
    for (const std::size_t i : {0, 1}) write(fmt::format("runs-{}.txt", i + 1), lines(i, ""));
    fill("array.sh", {{"COMMAND", command_}});
    fill("submit.sh", {{"NAME", name_}});
  }

  void parallel() {
    for (const std::size_t i : {0, 1}) {
      write(fmt::format("commands-{}.txt", i + 1), lines(i, command_ + " "));
    }
  }

  void snakemake() {
    std::string takes;
    for (const std::size_t i : {0, 1}) {
      for (const PlannedRun& run : lists_.at(i)) {
        const std::string& front =
            run.front_end_folder.empty() ? run.answers_folder : run.front_end_folder;
        takes += fmt::format("    \"{}\": \"{}\",\n", run.folder, i == 0 ? "" : front);
        std::error_code ignored;
        fs::remove(sweep_ / run.folder / "ended", ignored);  // of an earlier attempt
      }
    }
    fill("Snakefile", {{"TAKES", takes}, {"COMMAND", command_}});
  }

  Result<std::vector<fs::path>> result() const {
    if (!status_.isOk()) return status_;
    return written_;
  }

 private:
  /// The folders of list i, one a line; behind a command as words of a shell.
  std::string lines(std::size_t i, const std::string& command) const {
    std::string text;
    for (const PlannedRun& run : lists_.at(i)) {
      const std::string folder = (sweep_ / run.folder).string();
      text += command.empty() ? folder + "\n" : command + shellWord(folder) + "\n";
    }
    return text;
  }

  void fill(const std::string& file, const Placeholders& values) {
    const Result<std::string> text = filledTemplate(find_config_("configs/jobs/" + file), values);
    if (!text.isOk()) status_ = text.status();
    if (text.isOk()) write(file, text.value());
  }

  void write(const std::string& file, const std::string& text) {
    if (!status_.isOk()) return;
    status_ = record::writeAtomically(sweep_ / file, text);
    written_.push_back(sweep_ / file);
  }

  fs::path sweep_;
  std::string name_;
  const FindConfig& find_config_;
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

Result<std::string> filledTemplate(const fs::path& file, const Placeholders& values) {
  Result<std::string> text = text_encoding::readText(file);
  if (!text.isOk()) return text;
  for (const auto& [name, value] : values) {
    boost::replace_all(text.value(), "@" + name + "@", value);
  }
  return text;
}

Result<std::vector<fs::path>> writeJobFiles(const fs::path& sweep, const std::string& name,
                                            const std::vector<PlannedRun>& runs,
                                            const std::vector<std::string>& command,
                                            const std::string& kind,
                                            const FindConfig& find_config) {
  JobFiles files(sweep, name, runs, command, find_config);
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
