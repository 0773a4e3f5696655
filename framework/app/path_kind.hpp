// SPDX-License-Identifier: BSD-3-Clause
// What a path is that a person gave to a command: a run directory, a bag, a configuration. For one
// sentence instead of a parser's complaint if a command takes another kind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/exit_code.hpp"

namespace tolman::app {

enum class PathKind {
  Missing,
  Unknown,
  Folder,  ///< of none of the other kinds
  EmptyFolder,
  Run,        ///< run directory
  Sweep,      ///< folder of a sweep, or of its unpacked archive
  Point,      ///< folder of one run of a sweep
  Recording,  ///< folder that a source reads: KITTI, TUM, EuRoC, motion logs
  ImageFolder,
  Image,
  Bag,  ///< of ROS 1 or 2
  Configuration,
  SweepFile,
  PluginLibrary,
  Trajectory,  ///< lines of 8 or 12 numbers
  Table,       ///< of `sweep collect`
  Arrays,      ///< .npz
  Neurodata,   ///< .nwb
  Record,      ///< run.sqlite
};

/// What `plugins doctor` and `plugins validate` take.
inline constexpr const char* kPluginFile = "the library or program of a plugin";

/// Looks at names in a folder, and at the first bytes of a regular file. Never opens anything else.
PathKind kindOf(const std::filesystem::path& path);

/// "PATH: is a run directory, not a configuration; `tolman view`, ... take one". `wanted`: what the
/// command takes, with its article. Only for kinds other than Missing and Unknown.
std::string wrongKindText(const std::filesystem::path& path, PathKind kind,
                          const std::string& wanted);

/// Throws Ended with `code` and wrongKindText() if the path is of a kind that is known, but not
/// accepted. Of a missing or unknown path the command itself says more.
void requireKind(const std::filesystem::path& path, const std::vector<PathKind>& accepted,
                 const std::string& wanted, ExitCode code);

/// The same for what the source `kitti` reads: exit code 5. Of other sources it is not known what
/// they read.
void requireRecording(const std::filesystem::path& path, const std::string& source);

/// The same for a run directory: exit code 5. `also`: further kinds that are accepted.
void requireRun(const std::filesystem::path& path, const std::vector<PathKind>& also = {});

}  // namespace tolman::app
