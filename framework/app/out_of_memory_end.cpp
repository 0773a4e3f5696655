// SPDX-License-Identifier: BSD-3-Clause
#include "app/out_of_memory_end.hpp"

#include <unistd.h>

#include <cstdlib>
#include <new>

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
  for (const std::string_view text : {kOutOfMemory, std::string_view("\n")}) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  }
  endAtOnce(ExitCode::Internal);
}

}  // namespace

OutOfMemoryEnd::OutOfMemoryEnd() : before_(std::set_terminate(end)) {}

OutOfMemoryEnd::~OutOfMemoryEnd() { std::set_terminate(before_); }

}  // namespace tolman::app
