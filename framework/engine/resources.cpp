// SPDX-License-Identifier: BSD-3-Clause
#include "engine/resources.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace tolman::run {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kKiB = 1024;

/// The number behind `name` in a file of lines "name number"; -1 where there is none.
std::int64_t numberIn(const fs::path& file, const std::string& name) {
  std::ifstream stream(file);
  std::int64_t number = -1;
  for (std::string word; stream >> word;) {
    if (word == name && stream >> number) return number;
    stream.clear();
  }
  return -1;
}

/// The number that is the content of a file; -1 for "max", or if there is none.
std::int64_t numberOf(const fs::path& file) {
  std::ifstream stream(file);
  std::int64_t number = -1;
  return stream >> number ? number : -1;
}

std::optional<Memory> ofProcess() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  const std::int64_t used = kKiB * numberIn("/proc/self/status", "VmSize:");
  const auto all = static_cast<std::int64_t>(limit.rlim_cur);
  return Memory{all - used, all};
}

/// Memory of the control group (version 2). Cached files do not count as used.
std::optional<Memory> ofControlGroup() {
  std::ifstream stream("/proc/self/cgroup");
  std::string line;
  while (std::getline(stream, line) && !line.starts_with("0::/")) {
  }
  if (!line.starts_with("0::/")) return std::nullopt;
  const fs::path group = fs::path("/sys/fs/cgroup") / line.substr(4);
  const std::int64_t limit = numberOf(group / "memory.max");
  const std::int64_t used = numberOf(group / "memory.current");
  if (limit < 0 || used < 0) return std::nullopt;
  const std::int64_t cached =
      std::max<std::int64_t>(0, numberIn(group / "memory.stat", "inactive_file"));
  return Memory{limit - used + cached, limit};
}

std::optional<Memory> ofMachine() {
  const std::int64_t available = numberIn("/proc/meminfo", "MemAvailable:");
  const std::int64_t total = numberIn("/proc/meminfo", "MemTotal:");
  if (available < 0 || total < 0) return std::nullopt;
  return Memory{kKiB * available, kKiB * total};
}

std::int64_t sizeOf(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

}  // namespace

std::optional<Memory> memoryLeft() {
  std::optional<Memory> tightest;
  for (const std::optional<Memory>& memory : {ofProcess(), ofControlGroup(), ofMachine()}) {
    if (memory && (!tightest || memory->left < tightest->left)) tightest = memory;
  }
  return tightest;
}

std::optional<std::int64_t> diskLeft(const fs::path& directory) {
  std::error_code error;
  const fs::space_info space = fs::space(directory, error);
  if (error || space.capacity == 0) return std::nullopt;  // the file system does not report it
  return static_cast<std::int64_t>(space.available);
}

std::int64_t diskNeeded(const fs::path& directory) {
  constexpr std::int64_t kResults = 8 << 20;  // report and figures, of any run
  std::int64_t state = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(directory / "state", ignored)) {
    state += sizeOf(entry.path());
  }
  const std::int64_t trajectories = sizeOf(directory / "run.sqlite") / 8;
  return kResults + sizeOf(directory / "run.sqlite-wal") + 2 * state + trajectories;
}

std::int64_t residentMemory() {
  return kKiB * std::max<std::int64_t>(0, numberIn("/proc/self/status", "VmRSS:"));
}

void returnFreedMemory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace tolman::run
