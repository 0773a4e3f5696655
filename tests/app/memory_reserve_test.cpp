// SPDX-License-Identifier: BSD-3-Clause
// What a program has left after memory was short.
#include "app/memory_reserve.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

using tolman::app::MemoryReserve;

namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20U;

/// Bytes of address space that this process uses.
std::size_t used() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  unsigned long pages = 0;
  REQUIRE(std::fscanf(file, "%lu", &pages) == 1);
  std::fclose(file);
  return pages * 4096;
}

class Limited {
 public:
  explicit Limited(std::size_t left) {
    ::getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = used() + left;
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ~Limited() { ::setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};

/// MiB that can be allocated after an allocation has failed.
int leftAfterFailure() {
  std::vector<std::vector<char>> blocks;
  blocks.reserve(1000);
  bool has_failed = false;
  int left = 0;
  const Limited limited(40 * kMiB);
  while (blocks.size() < 1000) {
    try {
      blocks.emplace_back(kMiB);
      left += has_failed ? 1 : 0;
    } catch (const std::bad_alloc&) {
      if (has_failed) return left;
      has_failed = true;
    }
  }
  return left;
}

}  // namespace

TEST_CASE("after the first failure there are some MiB for the end, once") {
  const int without = leftAfterFailure();
  CHECK(without == 0);
  const MemoryReserve reserve;
  const int with = leftAfterFailure();
  CHECK(with >= 4);
  CHECK(with <= 8);
  CHECK(leftAfterFailure() == 0);  // it was used
}
