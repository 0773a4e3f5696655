// SPDX-License-Identifier: BSD-3-Clause
// A limit of open files (`ulimit -n`) as the cause of a failure, which looks like a wrong path.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace tolman::record {

inline constexpr const char* kMoreDescriptors = "; allow more open files (`ulimit -n`)";

/// Whether `error`, of errno, is of the process's or of the machine's limit.
inline bool isDescriptorLimit(int error) { return error == EMFILE || error == ENFILE; }

/// Whether fewer files can be opened now than a database needs (itself, its log, the index of the
/// log, its folder), for failures that do not come with errno.
inline bool areDescriptorsShort(int needed = 4) {
  const int file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (file < 0) return isDescriptorLimit(errno);
  const bool is_short = needed > 1 && areDescriptorsShort(needed - 1);
  ::close(file);
  return is_short;
}

}  // namespace tolman::record
