// SPDX-License-Identifier: BSD-3-Clause
// The limit of open files (`ulimit -n`) as the cause of a failure, which looks like a wrong path or
// a damaged file.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>

namespace tolman::file_opening {

inline constexpr const char* kMoreDescriptors = "; allow more open files (`ulimit -n`)";
inline constexpr const char* kNotOpened = "cannot be opened; allow more open files (`ulimit -n`)";

/// Whether `error`, of errno, is of the process's or of the machine's limit.
inline bool isDescriptorLimit(int error) { return error == EMFILE || error == ENFILE; }

/// Whether fewer files can be opened now than `needed`, for failures that do not come with errno. A
/// database needs four: itself, its log, the index of the log, its folder.
inline bool areDescriptorsShort(int needed) {
  const int file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (file < 0) return isDescriptorLimit(errno);
  const bool is_short = needed > 1 && areDescriptorsShort(needed - 1);
  ::close(file);
  return is_short;
}

/// What to say, after its name, of a file that just could not be opened: `otherwise`, unless no
/// file can be.
inline std::string notOpened(const std::string& otherwise) {
  return areDescriptorsShort(1) ? kNotOpened : otherwise;
}

}  // namespace tolman::file_opening
