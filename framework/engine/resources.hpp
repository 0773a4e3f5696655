// SPDX-License-Identifier: BSD-3-Clause
// The memory and disk space that a run may still use.
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

/// None if the system does not report it.
std::optional<Memory> memoryLeft();

/// Returns freed memory to the system. Long-lived data of map and record are between freed image
/// buffers, whose pages glibc keeps: without this the process grows twice as fast as its data.
void returnFreedMemory();

/// Bytes of this process that are in memory; 0 if the system does not report it.
std::int64_t residentMemory();

/// Bytes that an unprivileged user may still write below `directory`; none if not known.
std::optional<std::int64_t> diskLeft(const std::filesystem::path& directory);

/// Bytes that the run in `directory` needs for its end: the log of the record is merged into
/// run.sqlite, a state is saved, and results, figures and report are written.
std::int64_t diskNeeded(const std::filesystem::path& directory);

}  // namespace tolman::run
