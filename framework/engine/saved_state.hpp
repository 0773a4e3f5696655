// SPDX-License-Identifier: BSD-3-Clause
// The saved state of a run: place recognition, cells and map, in the folder `state` of its
// directory. There are two: session.json describes the state at the end, for a later run that
// continues the map; checkpoint.json the state after some frame of a run that has not finished.
#pragma once

#include <cstdint>
#include <filesystem>

#include "engine/checked_system.hpp"
#include "record/run_reader.hpp"

namespace tolman::engine {

/// A session whose state was loaded.
struct SavedSession {
  std::int64_t frames = 0;  ///< of all its sessions
  std::int64_t experiences = 0;
  bool finished = true;  ///< false: state of a checkpoint; the record may have later frames
};

/// Writes state/ROLE.bin for each of place, cells and map that can save its state, and then
/// state/session.json, which describes them. Each file is written atomically. `state` has frame and
/// counters. Nothing is written if no stage can save its state, or if one fails to
/// (`stage_failure`).
Status saveState(Assembly& assembly, const std::filesystem::path& directory, Checkpoint state,
                 Status& stage_failure);

/// Loads the state of the run in `directory` into a new assembly: the state at its end, else that
/// of its last checkpoint. Throws Failure for a damaged file, and for another plugin, version or
/// parameter than in the earlier run.
SavedSession loadState(Assembly& assembly, const std::filesystem::path& directory);

/// Writes state/checkpoint-FRAME-ROLE.bin and then state/checkpoint.json, so that there is a
/// complete checkpoint at any time; then removes the files of the previous one.
Status saveCheckpoint(Assembly& assembly, const std::filesystem::path& directory,
                      const Checkpoint& checkpoint);

/// Removes the checkpoint of a finished run whose last state is saved.
void removeCheckpoint(const std::filesystem::path& directory);

// Resumes an interrupted or killed run in its own directory. Place recognition, cells and map are
// loaded from the last checkpoint. Source and odometry, which save no state, process the frames up
// to it again; their stamps, true poses and motions must be those of the record.

/// Brings a new assembly to the state of the last checkpoint of the run in `directory`, which is
/// only read. Throws Failure (Continuation) for no checkpoint, a damaged one, other plugins or
/// other data. After a cancellation it returns early, and the assembly must not be used.
ResumePoint resumeAt(Assembly& assembly, const std::filesystem::path& directory,
                     const Cancellation& cancellation);

}  // namespace tolman::engine
