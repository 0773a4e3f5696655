// SPDX-License-Identifier: BSD-3-Clause
// What a run leaves for the next one: the state of place recognition, cells and map, in the folder
// `state` of its directory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/assembly.hpp"

namespace tolman::app {

/// How far a run has come when its state is saved.
struct Progress {
  std::int64_t frames = 0;  ///< of all its sessions
  std::int64_t experiences = 0;
  std::int64_t templates = -1;  ///< -1: not known
};

/// Writes state/STAGE.bin for each of place, cells and map that can save itself, and then
/// state/session.json, which says what they are. All appear whole or not at all. Fails when a
/// plugin or the disk does; a run with no such stage leaves nothing.
Status saveSession(Assembly& assembly, const std::filesystem::path& directory,
                   const Progress& progress);

/// Brings the stages of a fresh assembly to where the run of `directory` ended. The failure says
/// what to do: with another plugin, version or parameters the state is worthless, and so is a
/// damaged one.
std::variant<Progress, Failure> loadSession(Assembly& assembly,
                                            const std::filesystem::path& directory);

}  // namespace tolman::app
