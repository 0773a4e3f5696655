// SPDX-License-Identifier: BSD-3-Clause
// The folder of one run: its creation, the link `latest`, run.json, and which files are the run's.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "record/atomic_file.hpp"
#include "tolman/fields.hpp"

namespace tolman::record {

enum class RunState : std::uint8_t { Running, Finished, Failed, Interrupted };
inline constexpr std::array<std::string_view, 4> kRunStateNames = {"running", "finished", "failed",
                                                                   "interrupted"};
constexpr std::span<const std::string_view> enumNames(RunState) { return kRunStateNames; }

struct RunDirectoryOptions {
  std::filesystem::path root = "runs";  ///< parent of named directories
  std::string name = "run";
  std::int64_t utc_seconds = 0;              ///< since 1970, for the name
  std::optional<std::filesystem::path> out;  ///< this directory instead of a named one
  bool replace = false;                      ///< replace an earlier run in `out`
};

/// A locked folder: while this object exists, no other run writes into it.
class RunDirectory {
 public:
  /// Creates <root>/<name>-<UTC time> and links <root>/latest to it, or uses `out`: a new or empty
  /// folder, or with `replace` the folder of an earlier run, whose files are removed, and no
  /// others. Any other folder is refused.
  static Result<RunDirectory> create(const RunDirectoryOptions& options);

  /// Whether create() would take `path`, which need not exist; nothing is changed.
  static Status mayTake(const std::filesystem::path& path, bool replace);

  /// Opens the directory of an earlier run unchanged, to resume the run.
  static Result<RunDirectory> reopen(const std::filesystem::path& path);

  /// Whether a run is writing there at this moment.
  static bool isBeingWritten(const std::filesystem::path& path);
  /// run.json of the run there; null where there is none, or none that is JSON.
  static nlohmann::ordered_json readRunFile(const std::filesystem::path& path);
  /// Refuses a run whose run.json is missing or damaged.
  static Status checkRunFile(const std::filesystem::path& path);
  /// Whether the run was killed: run.json says "running", and no process holds the lock.
  static bool wasKilled(const std::filesystem::path& path);
  /// Whether run.json says that the run is finished or was interrupted, and no process continues
  /// it.
  static bool hasEnded(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }  ///< absolute
  /// Fails if the folder was moved, removed or replaced: path() may then be another run.
  Status stillInPlace() const;

  /// Removes what `export`, `report` or the end of a run computed from the record, which is about
  /// to change: trajectories, map, metrics, figures, run.npz, run.nwb and the exports of earlier
  /// sessions. Other files belong to the user and are kept. Failed if one cannot be removed.
  Status removeDerived() const;

  /// The text of run.json: the object `provenance` and "status".
  static std::string runFileText(nlohmann::ordered_json provenance, RunState state);

  /// Writes run.json, into this folder even if it was moved.
  Status writeRunFile(const nlohmann::ordered_json& provenance, RunState state) const;

 private:
  RunDirectory(std::filesystem::path path, FileDescriptor lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}
  static Result<RunDirectory> lock(const std::filesystem::path& path, const std::string& remedy);

  std::filesystem::path path_;
  FileDescriptor lock_;
};

/// Whether `directory` is a run directory: it has a run.sqlite, or a run.json with a status or
/// beside a config.resolved.yaml.
bool holdsRun(const std::filesystem::path& directory);

}  // namespace tolman::record
