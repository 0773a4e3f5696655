// SPDX-License-Identifier: BSD-3-Clause
// Which stages work at this moment, and since when; read by the watchdog of a run.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

#include "tolman/roles.hpp"

namespace tolman::pipeline {

/// All functions may be called from any thread. A role has at most one Mark at a time.
class StageActivity {
 public:
  /// The role counts as working while this object exists.
  class Mark {
   public:
    Mark(StageActivity& activity, Role role)
        : since_(activity.since_[static_cast<std::size_t>(role)]) {
      since_ = std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
    }
    ~Mark() { since_ = 0; }
    Mark(const Mark&) = delete;
    Mark& operator=(const Mark&) = delete;

   private:
    std::atomic<std::int64_t>& since_;
  };

  /// Time of the steady clock at which the role began its present work, ns; 0 while it waits.
  std::int64_t since(Role role) const { return since_[static_cast<std::size_t>(role)]; }

 private:
  std::array<std::atomic<std::int64_t>, kRoleNames.size()> since_{};
};

}  // namespace tolman::pipeline
