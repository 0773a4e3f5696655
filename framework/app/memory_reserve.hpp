// SPDX-License-Identifier: BSD-3-Clause
// Memory for the end of a program whose memory is short: destructors of libraries, such as those of
// JSON values, allocate, and an exception of theirs would abort it.
#pragma once

#include <new>

namespace tolman::app {

/// Holds a few MiB of address space. The first allocation by `new` that fails releases them, and
/// throws std::bad_alloc all the same. There is one handler in a process, so only one at a time.
class MemoryReserve {
 public:
  MemoryReserve();
  ~MemoryReserve();
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

 private:
  std::new_handler before_;
};

}  // namespace tolman::app
