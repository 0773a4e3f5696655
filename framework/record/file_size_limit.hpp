// SPDX-License-Identifier: BSD-3-Clause
// A limit of file sizes (`ulimit -f`) as the cause of a failed write, which looks like a full disk.
#pragma once

#include <sys/resource.h>

#include <string>

namespace tolman::record {

/// What to add to the message of a failed write; empty where file sizes are not limited.
inline std::string fileSizeLimit() {
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return "";
  return "; files are limited to " + std::to_string(limit.rlim_cur / 1024) +
         " KiB here, raise it (`ulimit -f unlimited`)";
}

}  // namespace tolman::record
