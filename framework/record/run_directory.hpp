// SPDX-License-Identifier: BSD-3-Clause
// The folder of one run: making it, `latest`, run.json.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "record/atomic_file.hpp"
#include "tolman/fields.hpp"

namespace tolman::record {

enum class RunState : std::uint8_t { Running, Finished, Failed, Interrupted };
inline constexpr std::array<std::string_view, 4> kRunStateNames = {"running", "finished", "failed",
                                                                   "interrupted"};
constexpr std::span<const std::string_view> enumNames(RunState) { return kRunStateNames; }

struct RunDirectoryOptions {
  std::filesystem::path root = "runs";  ///< of named directories
  std::string name = "run";
  std::int64_t utc_seconds = 0;              ///< since 1970, for the name
  std::optional<std::filesystem::path> out;  ///< this very directory instead of a named one
  bool replace = false;                      ///< the run that `out` holds
};

/// Holds a lock on the folder while it lives, so that no two runs write one.
class RunDirectory {
 public:
  /// Makes <root>/<name>-<UTC time> and points <root>/latest at it, or takes `out`: a new or empty
  /// folder, or with `replace` that of an earlier run, whose files are removed. Any other is
  /// refused.
  static Result<RunDirectory> create(const RunDirectoryOptions& options);

  /// Takes the directory of an earlier run as it is, for a run that goes on there.
  static Result<RunDirectory> reopen(const std::filesystem::path& path);

  /// Whether result files of `run` may be written to `folder`: not where another run is.
  static Status mayTakeFilesOf(const std::filesystem::path& run,
                               const std::filesystem::path& folder);
  /// Whether a run is writing there at this moment.
  static bool isBeingWritten(const std::filesystem::path& path);
  /// run.json of the run there; null where there is none, or none that is JSON.
  static nlohmann::ordered_json readRunFile(const std::filesystem::path& path);
  /// Whether the run was killed: run.json says "running", and no process holds the lock.
  static bool wasKilled(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }  ///< absolute
  /// Fails after the folder was moved, removed or replaced: then path() may be of another run.
  Status stillInPlace() const;

  /// Writes run.json: `provenance`, an object, and "status". Into this folder, also where it was
  /// moved to.
  Status writeRunFile(nlohmann::ordered_json provenance, RunState state) const;

 private:
  RunDirectory(std::filesystem::path path, FileDescriptor lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}
  static Result<RunDirectory> lock(const std::filesystem::path& path, const std::string& remedy);
  Status clear(bool replace) const;

  std::filesystem::path path_;
  FileDescriptor lock_;
};

}  // namespace tolman::record
