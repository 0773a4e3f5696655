// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <set>
#include <thread>

#include "experiment/sweep_runs.hpp"

namespace tolman::experiment {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kPoll(20);

// Exit codes of docs/errors.md, for a run that has no process or did not write its outcome.
constexpr int kNoProcess = 70;
constexpr int kInterrupted = 130;
constexpr int kNoProgram = 127;     // of a shell that cannot find the program
constexpr int kSignalOffset = 128;  // of a shell: 128 plus the number of the signal

struct Child {
  pid_t id = -1;
  std::size_t run = 0;  ///< index
};

/// Runs between fork() and exec(): it may only make calls that are safe in a fork of a process with
/// threads.
[[noreturn]] void becomeJob(const std::vector<char*>& arguments, const char* output, pid_t parent) {
  ::setpgid(0, 0);  // an interrupt from the terminal reaches the parent, which passes it on once
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(kInterrupted);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int file = ::open(output, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0) {
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
  }
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
  ::execv(arguments.front(), arguments.data());
  ::_exit(kNoProgram);
}

class Jobs {
 public:
  Jobs(const fs::path& sweep, const std::vector<PlannedRun>& runs, const LocalJobsOptions& options,
       const Cancellation& cancellation, JobsListener& listener)
      : sweep_(sweep),
        runs_(runs),
        options_(options),
        cancellation_(cancellation),
        listener_(listener) {
    state_.all = runs.size();
    for (const PlannedRun& run : runs) waiting_.insert(run.folder);
    for (std::size_t i = 0; i < runs.size(); ++i) todo_.push_back(i);
  }

  JobsState run() {
    bool interrupted = false;  // the children have been
    while (!children_.empty() || (!todo_.empty() && !stopping())) {
      if (!stopping()) startReady();
      if (stopping() && !interrupted) {
        interrupted = true;
        for (const Child& child : children_) ::kill(child.id, SIGINT);
      }
      std::this_thread::sleep_for(kPoll);
      collectEnded();
      show();
    }
    return state_;
  }

 private:
  bool stopping() const { return cancellation_.requested(); }

  /// Whether a run whose answers or map this run uses has not ended.
  bool mustWait(const PlannedRun& run) const {
    return waiting_.contains(run.front_end_folder) || waiting_.contains(run.answers_folder);
  }

  void startReady() {
    for (auto next = todo_.begin(); next != todo_.end() && children_.size() < options_.jobs;) {
      if (mustWait(runs_[*next])) {
        ++next;
        continue;
      }
      start(*next);
      next = todo_.erase(next);
    }
  }

  void start(std::size_t index) {
    std::vector<std::string> words = options_.command;
    words.push_back((sweep_ / runs_[index].folder).string());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string output = words.back() + "/output.txt";
    const pid_t parent = ::getpid();
    const pid_t id = ::fork();
    if (id == 0) becomeJob(arguments, output.c_str(), parent);
    if (id > 0) {
      children_.push_back({id, index});
      return;
    }
    end(index, {PointState::Failed, kNoProcess, std::string("no process: ") + std::strerror(errno),
                0, false});
  }

  void collectEnded() {
    for (auto child = children_.begin(); child != children_.end();) {
      int status = 0;
      if (::waitpid(child->id, &status, WNOHANG) != child->id) {
        ++child;
        continue;
      }
      const std::size_t index = child->run;
      child = children_.erase(child);
      end(index, outcome(index, status));
    }
  }

  /// The outcome that the process has written, or one from its exit status.
  PointOutcome outcome(std::size_t index, int status) {
    const fs::path folder = sweep_ / runs_[index].folder;
    PointOutcome outcome = outcomeOf(folder);
    if (outcome.state == PointState::Done || outcome.state == PointState::Failed) return outcome;
    if (stopping()) return {PointState::Interrupted, kInterrupted, "", 0, false};
    const bool by_signal = WIFSIGNALED(status);
    const int signal = WTERMSIG(status);
    outcome.state = PointState::Failed;
    outcome.exit_code = by_signal ? kSignalOffset + signal : WEXITSTATUS(status);
    outcome.message =
        by_signal
            ? fmt::format("the process was ended by signal {} ({})", signal, ::strsignal(signal))
            : fmt::format("the process ended with exit code {}", outcome.exit_code);
    outcome.message += "; see " + (folder / "output.txt").string();
    const Status written = writeOutcome(folder, outcome);
    if (!written.isOk()) outcome.message += "; " + written.message();
    return outcome;
  }

  void end(std::size_t index, const PointOutcome& outcome) {
    waiting_.erase(runs_[index].folder);
    if (outcome.state == PointState::Interrupted) return;
    ++state_.ended;
    if (outcome.state != PointState::Done) ++state_.failed;
    if (outcome.lostTracking()) ++state_.lost;
    listener_.onEnd(runs_[index], outcome, state_);
  }

  void show() {
    const auto now = std::chrono::steady_clock::now();
    state_.seconds = std::chrono::duration<double>(now - begin_).count();
    state_.running.clear();
    for (const Child& child : children_) state_.running.push_back(runs_[child.run].name);
    listener_.onState(state_);
  }

  fs::path sweep_;
  const std::vector<PlannedRun>& runs_;
  const LocalJobsOptions& options_;
  const Cancellation& cancellation_;
  JobsListener& listener_;
  std::vector<std::size_t> todo_;  ///< indices
  std::set<std::string> waiting_;  ///< folders of runs that have not ended
  std::vector<Child> children_;
  JobsState state_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

JobsState runLocally(const fs::path& sweep, const std::vector<PlannedRun>& runs,
                     const LocalJobsOptions& options, const Cancellation& cancellation,
                     JobsListener& listener) {
  return Jobs(sweep, runs, options, cancellation, listener).run();
}

}  // namespace tolman::experiment
