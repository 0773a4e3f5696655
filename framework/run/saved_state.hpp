// SPDX-License-Identifier: BSD-3-Clause
// The saved state of a run: place recognition, cells and map, in the folder `state` of its
// directory, for a later run that continues it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "run/assembly.hpp"

namespace tolman::run {

/// The size of a session when its state is saved.
struct SessionProgress {
  std::int64_t frames = 0;  ///< of all its sessions
  std::int64_t experiences = 0;
  std::int64_t templates = -1;  ///< -1: not known
};

/// Writes state/STAGE.bin for each of place, cells and map that can save its state, and then
/// state/session.json, which describes the files. Each file appears whole or not at all. Nothing is
/// written when no stage can save its state. Failures: a stage (kind Stage), or a file (Record).
std::optional<Failure> saveState(Assembly& assembly, const std::filesystem::path& directory,
                                 const SessionProgress& progress);

/// Loads the state that the run in `directory` saved into a fresh assembly. Throws Failed: a
/// damaged file, another plugin, version or parameters than those of the earlier run.
SessionProgress loadState(Assembly& assembly, const std::filesystem::path& directory);

}  // namespace tolman::run
