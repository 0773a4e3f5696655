// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>
#include <thread>

#include "base/must.hpp"
#include "base/text_file.hpp"
#include "evaluation/errors.hpp"
#include "experiment/comparison.hpp"
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

namespace {

/// The text as one word of a shell.
std::string shellWord(const std::string& text) {
  return "'" + boost::replace_all_copy(text, "'", "'\\''") + "'";
}

using Placeholders = std::map<std::string, std::string>;

/// configs/jobs/NAME with each @KEY@ replaced by its value.
std::string filled(const FindConfig& find_config, const std::string& name,
                   const Placeholders& values) {
  std::string text = must(text_encoding::readText(find_config("configs/jobs/" + name)));
  for (const auto& [key, value] : values) boost::replace_all(text, "@" + key + "@", value);
  return text;
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Replaces `from` where it is a whole value or the begin of a path.
void replacePath(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    const char after = at + from.size() < text.size() ? text[at + from.size()] : '\n';
    const bool whole = std::string_view("\n\"'/, ]}").find(after) != std::string_view::npos;
    if (whole) text.replace(at, from.size(), to);
    at += whole ? to.size() : from.size();
  }
}

}  // namespace

Result<std::vector<fs::path>> writeJobFiles(const fs::path& sweep, const std::string& name,
                                            const std::vector<PlannedRun>& runs,
                                            const std::vector<std::string>& command,
                                            const std::string& kind,
                                            const FindConfig& find_config) {
  std::string words;
  for (const std::string& word : command) words += (words.empty() ? "" : " ") + shellWord(word);
  std::array<std::string, 2> folders, commands;  // those of the second list after the first
  std::string takes;                             // what each run waits for
  for (const PlannedRun& run : runs) {
    const bool waits = std::ranges::find(runs, run.needs(), &PlannedRun::folder) != runs.end();
    const std::string folder = (sweep / run.folder).string();
    folders.at(waits ? 1 : 0) += folder + "\n";
    commands.at(waits ? 1 : 0) += words + " " + shellWord(folder) + "\n";
    takes += fmt::format("    \"{}\": \"{}\",\n", run.folder, waits ? run.needs() : "");
    std::error_code ignored;
    if (kind == "snakemake") fs::remove(folder + "/ended", ignored);  // of an earlier attempt
  }
  return resultOf([&] {
    std::vector<std::pair<const char*, std::string>> files;
    if (kind == "slurm") {
      files = {{"runs-1.txt", folders[0]},
               {"runs-2.txt", folders[1]},
               {"array.sh", filled(find_config, "array.sh", {{"COMMAND", words}})},
               {"submit.sh", filled(find_config, "submit.sh", {{"NAME", shellWord(name)}})}};
    } else if (kind == "parallel") {
      files = {{"commands-1.txt", commands[0]}, {"commands-2.txt", commands[1]}};
    } else {
      files = {
          {"Snakefile", filled(find_config, "Snakefile", {{"TAKES", takes}, {"COMMAND", words}})}};
    }
    std::vector<fs::path> written;
    for (const auto& [file, text] : files) {
      must(record::writeAtomically(written.emplace_back(sweep / file), text));
    }
    return written;
  });
}

Status writeSweepArchive(const fs::path& given, const fs::path& folder,
                         const FindConfig& find_config) {
  fs::path sweep = fs::absolute(given).lexically_normal();
  if (!sweep.has_filename()) sweep = sweep.parent_path();
  const auto add = [&](const fs::path& name, const std::string& text) {
    std::error_code ignored;
    fs::create_directories((folder / name).parent_path(), ignored);
    must(record::writeAtomically(folder / name, text));
  };
  const auto write = [&] {
    const auto rows = must(readRunRows({sweep}));
    if (rows.empty()) must(Status::invalidInput(sweep.string() + ": no run is done"));
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) must(Status::failed(folder.string() + ": " + error.message()));
    if (!fs::is_empty(folder, error)) must(Status::failed(folder.string() + ": is not empty"));
    add("results.csv", csvOf(tableOf(rows)));
    std::array<std::string, 2> runs;               // front ends first
    std::map<std::string, std::string> variables;  // by path
    std::string data_lines, names;
    for (const PlannedRun& run : frozenRuns(sweep).planned) {
      const fs::path from = sweep / run.folder, to = fs::path("runs") / run.folder;
      if (outcomeOf(from).state != PointState::Done) continue;
      std::string config = textOf(from / "config.yaml");
      // The front end that it replays is run again as well.
      if (!run.front_end_folder.empty()) {
        replacePath(config, (sweep / run.front_end_folder / "run").string(),
                    "${AGAIN}/" + run.front_end_folder);
      }
      for (const record::DataDigest& data : run.inputs.data) {
        const auto [variable, is_new] = variables.try_emplace(data.path);
        if (is_new) {
          variable->second = fmt::format("DATA_{}", variables.size());
          data_lines += fmt::format("{}\t{}\t{}\n", variable->second, data.path,
                                    data.sha256.empty() ? data.stamp : data.sha256);
        }
        replacePath(config, data.path, "${" + variable->second + ":-" + data.path + "}");
      }
      add(to / "config.resolved.yaml", config);
      add(to / "point.json", textOf(from / "point.json"));
      for (const char* name : {"run.json", "metrics.json", "results.sha256"}) {
        add(to / name, textOf(from / "run" / name));
      }
      runs.at(run.is_front_end ? 0 : 1) += run.folder + "\n";
    }
    for (const auto& [path, name] : variables) names += name + " ";
    add("rerun.sh",
        filled(find_config, "rerun.sh", {{"VARIABLES", names}, {"RUNS", runs[0] + runs[1]}}));
    add("data.txt", data_lines);
    return true;
  };
  return resultOf(write).status();
}

}  // namespace tolman::experiment
