// SPDX-License-Identifier: BSD-3-Clause
// What fails at every frame must not fill the log.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tolman::pipeline {

class FailureTally {
 public:
  enum class Tell { Yes, LastTime, No };
  /// One more failure of `who`.
  Tell count(std::string_view who) {
    const int failures = ++failures_[std::string(who)];
    return failures < kMostTold ? Tell::Yes : failures == kMostTold ? Tell::LastTime : Tell::No;
  }

 private:
  static constexpr int kMostTold = 10;
  std::map<std::string, int> failures_;
};

}  // namespace tolman::pipeline
