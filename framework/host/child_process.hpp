// SPDX-License-Identifier: BSD-3-Clause
// Starts a child process in its own process group and reports how it ended.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tolman::host {

/// How a process ended.
struct ProcessEnd {
  int signal = 0;     ///< 0 for none
  int exit_code = 0;  ///< if there was no signal
  /// "died of SIGSEGV (Segmentation fault)", "exited with code 3"
  std::string text() const;
};

/// "SIGSEGV (Segmentation fault)".
std::string signalName(int signal);

/// Forbids core files in this process and limits its data segment (0 for no limit).
void limitResources(std::uint64_t memory_mib);

class ChildProcess {
 public:
  /// Starts `command`. It inherits the descriptors of `passed` with the same numbers; its stdout
  /// and stderr go to `output`. Throws std::system_error.
  ChildProcess(const std::vector<std::string>& command, const std::vector<int>& passed,
               int output = 2);
  /// Kills the process and its group.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool hasEnded() const;
  /// Sends a signal to the process alone; nothing if it has ended.
  void signal(int number) const;
  /// Waits at most `timeout`, then kills the process and its group: what it started, unless that
  /// has left the group.
  ProcessEnd end(std::chrono::milliseconds timeout);

 private:
  void reap();
  pid_t pid_ = -1;
  bool reaped_ = false;
  ProcessEnd end_;
};

}  // namespace tolman::host
