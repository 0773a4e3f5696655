// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/sweep_folder.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>
#include <variant>

#include "config/json_text.hpp"
#include "config/text.hpp"
#include "config/values.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/run_directory.hpp"
#include "record/run_reader.hpp"

namespace tolman::record {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DataDigest, path, files, bytes, stamp, sha256)
}

namespace tolman::experiment {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Factor, name, label)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Inputs, host, plugins, data)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PlannedRun, name, key, config_sha256, front_end_sha256, factors,
                                   inputs, front_end_folder, answers_folder, keeps_answers,
                                   is_front_end)
NLOHMANN_JSON_SERIALIZE_ENUM(PointState, {{PointState::Failed, "failed"},
                                          {PointState::Interrupted, "interrupted"},
                                          {PointState::Done, "done"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PointOutcome, state, exit_code, message, wall_s, replayed)

namespace {

namespace fs = std::filesystem;
using PointJson = nlohmann::json;

PointJson readJson(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return PointJson::parse(stream, nullptr, false);
}

}  // namespace

Status freeze(const fs::path& sweep, const std::vector<PlannedRun>& todo,
              const std::vector<PlannedRun>& plan) {
  Status status;
  const auto write = [&](const fs::path& file, const std::string& text) {
    if (status.isOk()) status = record::writeAtomically(file, text, record::Sync::No);
  };
  for (const PlannedRun& run : todo) {
    const fs::path folder = sweep / run.folder;
    std::error_code error;
    if (fs::exists(folder / "point.json", error)) continue;
    fs::create_directories(folder, error);
    if (error) return Status::failed(folder.string() + ": " + error.message());
    write(folder / "config.yaml", run.config);
    write(folder / "point.json", config::jsonText(PointJson(run), 1) + "\n");
  }
  std::string order;
  for (const PlannedRun& run : plan) order += run.folder + "\n";
  write(sweep / "points.txt", order);
  return status;
}

Result<PlannedRun> readPoint(const fs::path& folder) {
  const fs::path file = folder / "point.json";
  try {
    auto run = readJson(file).get<PlannedRun>();
    run.folder = folder.filename().string();
    return run;
  } catch (const PointJson::exception&) {
    return Status::invalidInput(
        file.string() + ": " +
        config::absence(file, "is missing or damaged; is this the folder of a run of a sweep?"));
  }
}

FrozenRuns frozenRuns(const fs::path& sweep) {
  std::map<std::string, std::size_t> order;  // empty where there is no points.txt
  std::ifstream stream(sweep / "points.txt", std::ios::binary);
  for (std::string line; std::getline(stream, line);) order.try_emplace(line, order.size());
  FrozenRuns runs;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(sweep, error)) {
    if (!fs::exists(entry.path() / "point.json", error)) continue;
    auto run = readPoint(entry.path());
    if (!run.isOk()) continue;
    const bool planned = order.empty() || order.contains(run.value().folder);
    (planned ? runs.planned : runs.earlier).push_back(std::move(run).value());
  }
  for (const auto& [folder, place] : order) {
    if (std::ranges::find(runs.planned, folder, &PlannedRun::folder) == runs.planned.end()) {
      runs.missing.push_back(folder);
    }
  }
  std::ranges::sort(runs.earlier, {}, &PlannedRun::folder);
  std::ranges::sort(runs.planned, {}, [&](const PlannedRun& run) {
    return std::pair(order.empty() ? 0 : order.at(run.folder), run.folder);
  });
  return runs;
}

PointOutcome outcomeOf(const fs::path& folder) {
  const fs::path file = folder / "outcome.json";
  std::error_code ignored;
  if (fs::exists(file, ignored)) {
    try {  // values of other types are those of a failed run
      const auto outcome = readJson(file).get<PointOutcome>();
      const bool is_removed = !fs::exists(folder / "run/run.json", ignored);
      if (outcome.state == PointState::Done && is_removed) return {};
      return outcome;
    } catch (const PointJson::exception&) {
      constexpr int kFailed = 7;  // exit code of a sweep with failed runs
      return {PointState::Failed, kFailed, file.string() + ": is damaged; remove it"};
    }
  }
  if (record::RunDirectory::isBeingWritten(folder)) return {PointState::Running};
  return {fs::exists(folder / "run", ignored) ? PointState::Interrupted : PointState::Planned};
}

Status writeOutcome(const fs::path& folder, const PointOutcome& outcome) {
  return record::writeAtomically(folder / "outcome.json",
                                 config::jsonText(PointJson(outcome), 1) + "\n");
}

namespace {

namespace fs = std::filesystem;
using engine::FailureKind;

constexpr const char* kPlanAgain =
    " has changed since the run was planned; plan it again with "
    "`tolman sweep`, which makes a new run of it";

[[noreturn]] void refuse(FailureKind kind, const std::string& message) {
  throw engine::Failure({kind, message});
}

void requireUnchanged(const fs::path& folder, const PlannedRun& point) {
  const auto config = record::fileDigest(folder / "config.yaml");
  if (!config.isOk() || config.value() != point.config_sha256) {
    refuse(
        FailureKind::Configuration,
        (folder / "config.yaml").string() +
            " has changed since the run was planned; change the file of the sweep instead, remove "
            "this folder, and plan again with `tolman sweep`");
  }
  const Inputs& inputs = point.inputs;
  const auto host = record::fileDigest("/proc/self/exe");
  if (!host.isOk() || host.value() != inputs.host) {
    refuse(FailureKind::Configuration, std::string("tolman") + kPlanAgain);
  }
  for (const auto& [file, digest] : inputs.plugins) {
    const auto now = record::fileDigest(file);
    if (!now.isOk() || now.value() != digest) refuse(FailureKind::Plugin, file + kPlanAgain);
  }
  for (const record::DataDigest& data : inputs.data) {
    const auto now = record::digestData(data.path, data);
    engine::require(now.status(), FailureKind::Dataset);
    const bool same =
        data.sha256.empty() ? now.value().stamp == data.stamp : now.value().sha256 == data.sha256;
    if (!same) refuse(FailureKind::Dataset, data.path + kPlanAgain);
  }
}

/// The configuration to run: the frozen one, or a copy that replays the answers of another run.
std::string configOf(const fs::path& folder, const PlannedRun& point,
                     const PointRunOptions& options, bool& replayed) {
  const fs::path sweep = folder.parent_path();
  if (!point.front_end_folder.empty()) {
    const PointOutcome front = outcomeOf(sweep / point.front_end_folder);
    if (front.state != PointState::Done ||
        !record::canBeReplayed(sweep / point.front_end_folder / "run")) {
      refuse(FailureKind::Dataset, "the run " + point.front_end_folder +
                                       ", which this one needs, is " +
                                       std::string(enumName(front.state)));
    }
  }
  const fs::path answers = sweep / point.answers_folder / "run";
  replayed = !point.answers_folder.empty() && record::canBeReplayed(answers);
  if (!replayed) return (folder / "config.yaml").string();
  const std::string yaml = "extends: [config.yaml, \"" +
                           fs::absolute(options.find_config("experiments/replay")).string() +
                           "\"]\n";
  engine::require(record::writeAtomically(folder / "replay.yaml", yaml, record::Sync::No),
                  FailureKind::Record);
  ::setenv("REPLAY_RUN", fs::absolute(answers).c_str(), 1);  // no other thread reads it
  return (folder / "replay.yaml").string();
}

engine::Outcome execute(const fs::path& folder, const PlannedRun& point,
                        const PointRunOptions& options, const Cancellation& cancellation,
                        bool& replayed) {
  requireUnchanged(folder, point);
  engine::SystemOptions system{
      configOf(folder, point, options, replayed), {}, options.plugin_paths};
  system.quiet = true;
  if (options.threads > 0) {
    system.overrides.push_back("threads=" + std::to_string(options.threads));
  }
  if (replayed) system.overrides.push_back("name=\"" + point.name + "\"");
  engine::CheckedSystem checked = engine::checkSystem(system);
  engine::RunLog log(options.quiet);
  const engine::SteadyClock clock;
  engine::Run run(
      log, clock, cancellation,
      {folder / "run", true, {}, options.command_line, point.keeps_answers, options.exit_code});
  return run.execute(std::move(checked));
}

/// Removes a run directory without a record, which a new run would refuse to replace.
void removeUnfinished(const fs::path& run) {
  std::error_code ignored;
  if (!fs::exists(run / "run.json", ignored) && !fs::exists(run / "run.sqlite", ignored)) {
    fs::remove_all(run, ignored);
  }
}

bool hasEnded(const PointOutcome& outcome) {
  return outcome.state == PointState::Done || outcome.state == PointState::Failed;
}

/// Waits while another process runs this point, for another point that needs it, or because its
/// sweep was killed just before.
record::FileDescriptor lockWhenFree(const fs::path& folder, const Cancellation& cancellation) {
  for (;;) {
    record::FileDescriptor lock = record::lockFolder(folder);
    std::error_code ignored;
    if (lock.isOpen() || cancellation.requested() || !fs::is_directory(folder, ignored))
      return lock;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

}  // namespace

PointOutcome runPoint(const fs::path& given, const PointRunOptions& options,
                      const Cancellation& cancellation) {
  const fs::path folder = fs::absolute(given).lexically_normal();
  std::error_code ignored;
  const bool is_point = fs::exists(folder / "point.json", ignored);
  const std::string problem =
      config::absence(folder, is_point ? "" : "is no folder of a run of a sweep");
  if (!problem.empty()) {
    return {PointState::Failed, options.failure_code({FailureKind::Configuration, ""}),
            folder.string() + ": " + problem};
  }
  const record::FileDescriptor lock = lockWhenFree(folder, cancellation);
  if (!lock.isOpen()) return {PointState::Interrupted};
  PointOutcome outcome = outcomeOf(folder);
  if (hasEnded(outcome)) return outcome;
  const auto point = readPoint(folder);
  if (point.isOk() && !point.value().needs().empty()) {
    const fs::path needed = folder.parent_path() / point.value().needs();
    if (!hasEnded(outcomeOf(needed))) (void)runPoint(needed, options, cancellation);
  }
  const auto begin = std::chrono::steady_clock::now();
  outcome = {PointState::Failed};
  fs::remove(folder / "outcome.json", ignored);
  try {
    engine::require(point.status(), FailureKind::Configuration);
    removeUnfinished(folder / "run");
    const engine::Outcome ran =
        execute(folder, point.value(), options, cancellation, outcome.replayed);
    outcome.exit_code = options.exit_code(ran);
    if (ran.failure) outcome.message = ran.failure->message;
    if (!ran.failure) outcome.state = ran.interrupted ? PointState::Interrupted : PointState::Done;
    if (outcome.lostTracking()) {
      outcome.message = "odometry was not tracking at the end, or found no motion in the whole run";
    }
  } catch (const engine::Failure& failed) {
    outcome.exit_code = options.failure_code(failed);
    outcome.message = failed.what();
  }
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (outcome.state == PointState::Interrupted || cancellation.requested()) return outcome;
  const Status written = writeOutcome(folder, outcome);
  if (!written.isOk()) {
    const int code = options.failure_code({FailureKind::Record, written.message()});
    outcome = {PointState::Failed, code, written.message(), outcome.wall_s};
  }
  return outcome;
}

}  // namespace tolman::experiment
