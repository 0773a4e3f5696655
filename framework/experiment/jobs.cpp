// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <system_error>
#include <thread>

#include "evaluation/errors.hpp"
#include "experiment/sweep_folder.hpp"
#include "host/child_process.hpp"
#include "record/atomic_file.hpp"

namespace tolman::experiment {

namespace {

namespace fs = std::filesystem;

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
      const bool waits = waiting_.contains(run.needs());
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
    durations_[takesAnswers(run)].push_back(outcome.wall_s);
    forecast(run);
    if (outcome.state != PointState::Done) ++state_.failed;
    if (outcome.lostTracking()) ++state_.lost;
    options_.on_end(run, outcome, state_);
  }

  static bool takesAnswers(const PlannedRun& run) {
    return !run.front_end_folder.empty() || !run.answers_folder.empty();
  }

  /// From the median run of each kind: a run that takes the answers of another is much shorter.
  void forecast(const PlannedRun& ended) {
    std::array<double, 2> count{};
    for (const PlannedRun* run : todo_) ++count[takesAnswers(*run)];
    for (const Job& job : running_) {
      if (job.run != &ended) count[takesAnswers(*job.run)] += 0.5;  // half done
    }
    state_.left_s = 0;
    for (const std::size_t kind : {0, 1}) {
      if (count[kind] == 0) continue;
      if (durations_[kind].empty()) {
        state_.left_s = -1;
        return;
      }
      state_.left_s += count[kind] * evaluation::statistics(durations_[kind]).median /
                       static_cast<double>(options_.jobs);
    }
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
  std::array<std::vector<double>, 2> durations_;  ///< s, of runs with and without own answers
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

JobsState runLocally(const fs::path& sweep, const std::vector<PlannedRun>& runs,
                     const LocalJobsOptions& options, const Cancellation& cancellation) {
  return Jobs(sweep, runs, options, cancellation).run();
}

}  // namespace tolman::experiment
