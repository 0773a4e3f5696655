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

/// Resident memory of this process, MiB.
double residentMib();
double peakResidentMib();
void resetPeakResident();

/// Captures stdout and stderr of this process during its lifetime.
class OutputCapture {
 public:
  OutputCapture();
  ~OutputCapture();
  OutputCapture(const OutputCapture&) = delete;
  OutputCapture& operator=(const OutputCapture&) = delete;
  /// The first 200 bytes written so far.
  std::string out() const;
  std::string err() const;

 private:
  struct Stream {
    int descriptor;
    int saved;
    int file;
  };
  static Stream redirect(int descriptor);
  static std::string contents(const Stream& stream);
  Stream out_;
  Stream err_;
};

}  // namespace tolman::conformance
