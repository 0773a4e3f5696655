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

  Status write(const FindConfig& find_config) {
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
    std::string names;
    for (const auto& [path, name] : variables_) names += name + " ";
    const Result<std::string> script = filledTemplate(
        find_config("configs/jobs/rerun.sh"), {{"VARIABLES", names}, {"RUNS", fronts_ + runs_}});
    if (!script.isOk()) return script.status();
    add("rerun.sh", script.value());
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

  fs::path sweep_;
  fs::path folder_;
  std::map<std::string, std::string> variables_;  ///< by path
  std::string data_;
  std::string fronts_;
  std::string runs_;
  Status status_;
};

}  // namespace

Status writeSweepArchive(const fs::path& sweep, const fs::path& folder,
                         const FindConfig& find_config) {
  return Archive(sweep, folder).write(find_config);
}

}  // namespace tolman::experiment
