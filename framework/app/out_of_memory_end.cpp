// SPDX-License-Identifier: BSD-3-Clause
#include "app/out_of_memory_end.hpp"

#include <unistd.h>

#include <cstdlib>
#include <new>
#include <string_view>

#include "app/exit_guard.hpp"

namespace tolman::app {
namespace {

bool isForLackOfMemory() {
  if (std::current_exception() == nullptr) return false;
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

[[noreturn]] void end() {
  if (!isForLackOfMemory()) std::abort();
  constexpr std::string_view kText =
      "tolman: out of memory; give it more (`ulimit -v`), or less to do\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kText.data(), kText.size());
  endAtOnce(ExitCode::Internal);
}

}  // namespace

OutOfMemoryEnd::OutOfMemoryEnd() : before_(std::set_terminate(end)) {}

OutOfMemoryEnd::~OutOfMemoryEnd() { std::set_terminate(before_); }

}  // namespace tolman::app
