// SPDX-License-Identifier: BSD-3-Clause
// What a run may still use of memory and disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace tolman::run {

/// Memory, by the tightest limit: of the process (ulimit -v), of its control group, of the machine.
struct Memory {
  std::int64_t left = 0;   ///< bytes
  std::int64_t limit = 0;  ///< bytes
};

/// Nothing where the system does not say.
std::optional<Memory> memoryLeft();

/// Gives freed memory back to the system. What map and record keep lies between buffers of images
/// that were freed, whose pages glibc holds: without this the process grows by twice what it uses.
void returnFreedMemory();

/// Bytes that an ordinary user may still write below `directory`.
std::optional<std::int64_t> diskLeft(const std::filesystem::path& directory);

/// Bytes that the run in `directory` needs to end well: the log of the record is merged into
/// run.sqlite, a state is saved, and results, figures and report are written.
std::int64_t diskNeeded(const std::filesystem::path& directory);

}  // namespace tolman::run
