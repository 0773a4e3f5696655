// SPDX-License-Identifier: BSD-3-Clause
// A request to stop a run, with its reason.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>

#include "engine/failure.hpp"
#include "tolman/context.hpp"

namespace tolman::run {

/// Cancellation by the caller of a run, or by the run itself with a reason.
class StopRequest : public Cancellation {
 public:
  explicit StopRequest(const Cancellation& caller) : caller_(caller) {}
  bool requested() const override { return stopped_ || caller_.requested(); }

  /// Stops the run. If it is called again, the first reason is kept.
  void stop(Failure reason) {
    const std::lock_guard lock(mutex_);
    if (!reason_) reason_ = std::move(reason);
    stopped_ = true;
  }
  /// Why the run stopped itself; none if it was not stopped, or cancelled by the caller.
  std::optional<Failure> reason() const {
    const std::lock_guard lock(mutex_);
    return reason_;
  }

 private:
  const Cancellation& caller_;
  std::atomic<bool> stopped_ = false;
  mutable std::mutex mutex_;  // guards the reason
  std::optional<Failure> reason_;
};

}  // namespace tolman::run
