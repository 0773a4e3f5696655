// SPDX-License-Identifier: BSD-3-Clause
// The newest events, numbered, so that each client gets every event once.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::web_viewer {

class EventLog {
 public:
  void append(const std::vector<RunEvent>& events) {
    events_.insert(events_.end(), events.begin(), events.end());
    end_ += events.size();
    while (events_.size() > kMax) events_.pop_front();
  }
  std::size_t end() const { return end_; }

  /// The newest events from number `next` on, at most `count`.
  std::vector<RunEvent> since(std::size_t next, std::size_t count) const {
    const std::size_t missed = end_ - std::min(next, end_);
    const std::size_t sent = std::min({missed, count, events_.size()});
    return {events_.end() - static_cast<std::ptrdiff_t>(sent), events_.end()};
  }

 private:
  static constexpr std::size_t kMax = 1000;
  std::deque<RunEvent> events_;
  std::size_t end_ = 0;
};

}  // namespace tolman::web_viewer
