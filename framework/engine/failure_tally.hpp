// SPDX-License-Identifier: BSD-3-Clause
// Counts failures by name, so that a failure at every frame does not fill the log.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tolman::pipeline {

class FailureTally {
 public:
  enum class Report { Yes, Last, No };
  /// Counts a failure of `who`. Returns whether to report it: the first ten are reported.
  Report count(std::string_view who) {
    const int failures = ++failures_[std::string(who)];
    return failures < kMaxReports    ? Report::Yes
           : failures == kMaxReports ? Report::Last
                                     : Report::No;
  }

 private:
  static constexpr int kMaxReports = 10;
  std::map<std::string, int> failures_;
};

}  // namespace tolman::pipeline
