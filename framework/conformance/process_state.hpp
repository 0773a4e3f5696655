// SPDX-License-Identifier: BSD-3-Clause
// Global state of the process, which a plugin must not change, and its resources.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tolman::conformance {

/// Locale, signal handlers, rounding mode, working directory, environment, ... as text by name.
using ProcessState = std::map<std::string, std::string>;
ProcessState processState();

/// "working directory: '/a' became '/b'", one for each difference.
std::vector<std::string> differences(const ProcessState& before, const ProcessState& after);

/// Threads of OpenCV, or -1 when it is not loaded.
int openCvThreads();

/// Number of threads. Waits up to 0.5 s for it to fall to `expected`.
std::size_t threadCount(std::size_t expected);

/// The target of each open file descriptor.
std::map<int, std::string> openFiles();

/// Memory of this process, MiB: "VmRSS:", resident, or "VmHWM:", the peak since resetPeak().
double memoryMib(const char* key);
void resetPeak();

/// Captures stdout (1) or stderr (2) of this process during its lifetime.
class OutputCapture {
 public:
  explicit OutputCapture(int descriptor);
  ~OutputCapture();
  OutputCapture(const OutputCapture&) = delete;
  OutputCapture& operator=(const OutputCapture&) = delete;
  /// The first 200 bytes written so far.
  std::string text() const;

 private:
  int descriptor_;
  int saved_;
  int file_;
};

}  // namespace tolman::conformance
