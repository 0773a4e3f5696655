// SPDX-License-Identifier: BSD-3-Clause
// The end of a program that lacks memory where no exception can leave: in the initialisers and
// destructors of libraries.
#pragma once

#include <exception>
#include <string_view>

namespace tolman::app {

/// The sentence of a program that lacks memory.
inline constexpr std::string_view kOutOfMemory =
    "tolman: out of memory; give it more (`ulimit -v`), or less to do";

/// While one exists, a std::bad_alloc that cannot be caught ends the process with a sentence and
/// ExitCode::Internal, not by a signal. There is one handler in a process, so only one at a time.
class OutOfMemoryEnd {
 public:
  OutOfMemoryEnd();
  ~OutOfMemoryEnd();
  OutOfMemoryEnd(const OutOfMemoryEnd&) = delete;
  OutOfMemoryEnd& operator=(const OutOfMemoryEnd&) = delete;

 private:
  std::terminate_handler before_;
};

}  // namespace tolman::app
