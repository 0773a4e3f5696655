// SPDX-License-Identifier: BSD-3-Clause
// Where a program that a plugin interprets (plugin: python) was when it did not return or died: its
// interpreter writes its stack into shared memory when the host asks for it by a signal.
#pragma once

#include <string>

#include "host/child_process.hpp"
#include "host/shared_buffer.hpp"

namespace tolman::isolation {

/// Variable with the number of the descriptor, in the environment of the plugin's process. An
/// interpreter that takes part writes any first line there, and from then on, at kStackSignal, a
/// line `  File "PATH", line N in FUNCTION` for each call, the innermost first: what `faulthandler`
/// of Python writes. It may write the same when a signal such as SIGSEGV ends the process.
inline constexpr const char* kStackVariable = "TOLMAN_STACK_DESCRIPTOR";
inline constexpr int kStackSignal = 12;  // SIGUSR2

class StackReport {
 public:
  /// Throws std::system_error.
  StackReport() : memory_("tolman-stack") {}
  /// To be passed to the process.
  int descriptor() const { return memory_.descriptor(); }
  /// Asks the process, and waits for half a second at most. "mine.py:12, in step": the innermost
  /// call in the file `program` or in its folder; empty if the interpreter does not answer.
  std::string ask(const ChildProcess& process, const std::string& program) const;
  /// The same of the stack that the interpreter wrote when the process died.
  std::string left(const std::string& program) const;

 private:
  std::string text() const;
  SharedBuffer memory_;
};

/// The same of the text of a stack. Exposed for its test.
std::string placeInStack(const std::string& stack, const std::string& program);

}  // namespace tolman::isolation
