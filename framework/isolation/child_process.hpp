// SPDX-License-Identifier: BSD-3-Clause
// A child process in a group of its own, and what became of it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tolman::isolation {

/// How a process ended.
struct ProcessEnd {
  int signal = 0;     ///< 0 for none
  int exit_code = 0;  ///< without a signal
  /// "died of SIGSEGV (Segmentation fault)", "ended the process itself (exit code 3)"
  std::string text() const;
};

/// "SIGSEGV (Segmentation fault)".
std::string signalName(int signal);

/// Bounds this process: no core files, and so much data (0: any amount). Only system calls, so that
/// it may stand between fork() and exec().
void limitResources(std::uint64_t memory_mib);

class ChildProcess {
 public:
  /// Starts `command`; it inherits the descriptors of `passed` under their own numbers, and writes
  /// what it would print to the standard error. Throws std::system_error.
  ChildProcess(const std::vector<std::string>& command, const std::vector<int>& passed);
  /// Kills what is left of it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool hasEnded() const;
  /// Kills it, and what it started, unless it is gone within `patience`.
  ProcessEnd end(std::chrono::milliseconds patience);

 private:
  void reap();
  pid_t pid_ = -1;
  bool reaped_ = false;
  ProcessEnd end_;
};

}  // namespace tolman::isolation
