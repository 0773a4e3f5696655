// SPDX-License-Identifier: BSD-3-Clause
// What a process has only one of, and what a plugin must leave alone.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tolman::conformance {

/// Locale, signal handlers, rounding, folder, environment ..., as texts under their names.
using ProcessState = std::map<std::string, std::string>;
ProcessState processState();

/// "working directory: '/a' became '/b'", one for each difference.
std::vector<std::string> differences(const ProcessState& before, const ProcessState& after);

/// Threads of OpenCV, or -1 when no plugin brought it.
int openCvThreads();

/// Ids of all threads; those that are about to end are waited for a moment.
std::size_t threadCount(std::size_t expected);

/// What each open descriptor leads to, without the one that is needed to look.
std::map<int, std::string> openFiles();

/// Bytes that are allocated on the heap now.
std::size_t heapBytes();

/// Memory of this process, MiB.
double residentMib();
double peakResidentMib();
void resetPeakResident();

/// Catches what is written to stdout and stderr while it lives.
class OutputTrap {
 public:
  OutputTrap();
  ~OutputTrap();
  OutputTrap(const OutputTrap&) = delete;
  OutputTrap& operator=(const OutputTrap&) = delete;
  /// What was written so far, cut off after 200 bytes.
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
