// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>

#include "experiment/comparison.hpp"
#include "experiment/sweep_folder.hpp"
#include "record/atomic_file.hpp"

namespace tolman::experiment {

namespace {

namespace fs = std::filesystem;

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

class Archive {
 public:
  Archive(const fs::path& sweep, fs::path folder)
      : sweep_(fs::absolute(sweep).lexically_normal()), folder_(std::move(folder)) {
    if (!sweep_.has_filename()) sweep_ = sweep_.parent_path();
  }

  Status write() {
    const auto rows = readRunRows({sweep_});
    if (!rows.isOk()) return rows.status();
    if (rows.value().empty()) return Status::invalidInput(sweep_.string() + ": no run is done");
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) return Status::failed(folder_.string() + ": " + error.message());
    if (!fs::is_empty(folder_, error)) return Status::failed(folder_.string() + ": is not empty");
    add("results.csv", csvOf(tableOf(rows.value())));
    for (const PlannedRun& run : frozenRuns(sweep_).planned) {
      if (outcomeOf(sweep_ / run.folder).state == PointState::Done) addRun(run);
    }
    add("rerun.sh", script());
    add("data.txt", data_);
    return status_;
  }

 private:
  void add(const fs::path& name, const std::string& text) {
    std::error_code ignored;
    fs::create_directories((folder_ / name).parent_path(), ignored);
    if (status_.isOk()) status_ = record::writeAtomically(folder_ / name, text);
  }

  void addRun(const PlannedRun& run) {
    const fs::path from = sweep_ / run.folder;
    const fs::path to = fs::path("runs") / run.folder;
    std::string config = textOf(from / "config.yaml");
    // The front end that it replays is run again as well.
    if (!run.front_end_folder.empty()) {
      replacePath(config, (sweep_ / run.front_end_folder / "run").string(),
                  "${AGAIN}/" + run.front_end_folder);
    }
    for (const record::DataDigest& data : run.inputs.data) {
      replacePath(config, data.path, "${" + variable(data) + ":-" + data.path + "}");
    }
    add(to / "config.resolved.yaml", config);
    add(to / "point.json", textOf(from / "point.json"));
    for (const char* name : {"run.json", "metrics.json", "results.sha256"}) {
      add(to / name, textOf(from / "run" / name));
    }
    (run.is_front_end ? fronts_ : runs_) += run.folder + "\n";
  }

  const std::string& variable(const record::DataDigest& data) {
    const auto [found, is_new] = variables_.try_emplace(data.path);
    if (is_new) {
      found->second = fmt::format("DATA_{}", variables_.size());
      data_ += fmt::format("{}\t{}\t{}\n", found->second, data.path,
                           data.sha256.empty() ? data.stamp : data.sha256);
    }
    return found->second;
  }

  /// Shell commands that make relative paths in the variables absolute.
  std::string absolutePaths() const {
    std::string text;
    for (const auto& [path, name] : variables_) {
      text += fmt::format("case ${{{0}-/}} in /*) ;; *) export {0}=\"$PWD/${0}\" ;; esac\n", name);
    }
    return text;
  }

  std::string script() const {
    return "#!/bin/sh\n"
           "# Runs all runs of the archive again and compares the results, byte for byte. data.txt "
           "lists the variables\n"
           "# for data that lie elsewhere now:\n"
           "#   TOLMAN=/usr/bin/tolman DATA_1=/data/00 sh rerun.sh\n"
           "# The new runs go to $AGAIN, what they say beside them. The exit code is 0 where all\n"
           "# results are the same, 2 where a run could not be made, otherwise 1.\n" +
           absolutePaths() +
           "cd \"$(dirname \"$0\")\" || exit 2\n"
           "TOLMAN=${TOLMAN:-tolman}\nAGAIN=${AGAIN:-$PWD/again}\nexport AGAIN\nended=0\n"
           "mkdir -p \"$AGAIN\"\nwhile read -r run; do\n"
           "  said=\"$AGAIN/$run.txt\"\n  rm -f \"$AGAIN/$run/results.sha256\"\n"
           "  if \"$TOLMAN\" rerun \"runs/$run\" --force --out \"$AGAIN/$run\" --verify </dev/null "
           ">\"$said\" 2>&1\n"
           "  then echo \"same     $run\"\n"
           "  elif [ -f \"$AGAIN/$run/results.sha256\" ]\n"
           "  then [ $ended = 2 ] || ended=1; echo \"differs  $run (see $said)\"\n"
           "  else ended=2; echo \"not run  $run (see $said)\"; tail -n 3 \"$said\" >&2\n  fi\n"
           "done <<RUNS\n" +
           fronts_ + runs_ + "RUNS\nexit $ended\n";
  }

  fs::path sweep_;
  fs::path folder_;
  std::map<std::string, std::string> variables_;  ///< by path
  std::string data_;
  std::string fronts_;
  std::string runs_;
  Status status_;
};

}  // namespace

Status writeSweepArchive(const fs::path& sweep, const fs::path& folder) {
  return Archive(sweep, folder).write();
}

}  // namespace tolman::experiment
