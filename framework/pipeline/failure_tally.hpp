// SPDX-License-Identifier: BSD-3-Clause
// Counts failures by name, so that what fails at every frame does not fill the log.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tolman::pipeline {

class FailureTally {
 public:
  enum class Report { Yes, Last, No };
  /// One more failure of `who`; whether it is to be reported.
  Report count(std::string_view who) {
    const int failures = ++failures_[std::string(who)];
    return failures < kMostReports    ? Report::Yes
           : failures == kMostReports ? Report::Last
                                      : Report::No;
  }

 private:
  static constexpr int kMostReports = 10;
  std::map<std::string, int> failures_;
};

}  // namespace tolman::pipeline
