// SPDX-License-Identifier: BSD-3-Clause
// The saved state of a run: place recognition, cells and map, in the folder `state` of its
// directory. There are two: session.json describes the state at the end, for a later run that
// continues the map; checkpoint.json the state after some frame of a run that has not finished.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "pipeline/checkpoint.hpp"
#include "run/assembly.hpp"

namespace tolman::run {

/// The size of a session when its state is saved.
struct SessionProgress {
  std::int64_t frames = 0;  ///< of all its sessions
  std::int64_t experiences = 0;
  std::int64_t templates = -1;  ///< -1: not known
  bool finished = true;         ///< false: of a checkpoint, and the record may have later frames
};

/// Writes state/STAGE.bin for each of place, cells and map that can save its state, and then
/// state/session.json, which describes the files. Each file appears whole or not at all. Nothing is
/// written when no stage can save its state. Failures: a stage (kind Stage), or a file (Record).
std::optional<Failure> saveState(Assembly& assembly, const std::filesystem::path& directory,
                                 const SessionProgress& progress);

/// Loads the state that the run in `directory` saved into a fresh assembly: that of its end, else
/// of its last checkpoint. Throws Failed: a damaged file, another plugin, version or parameters
/// than those of the earlier run.
SessionProgress loadState(Assembly& assembly, const std::filesystem::path& directory);

/// Writes state/checkpoint-FRAME-STAGE.bin and then state/checkpoint.json, so that at any moment
/// there is one whole checkpoint; the files of the one before go.
Status saveCheckpoint(Assembly& assembly, const std::filesystem::path& directory,
                      const pipeline::Checkpoint& checkpoint);

/// Loads the checkpoint of the run in `directory` into a fresh assembly; its `states` stay empty.
/// Throws Failed, as loadState().
pipeline::Checkpoint loadCheckpoint(Assembly& assembly, const std::filesystem::path& directory);

/// A run that has finished, with all of its files, needs none where its last state is saved.
void removeCheckpoint(const std::filesystem::path& directory);

}  // namespace tolman::run
