// SPDX-License-Identifier: BSD-3-Clause
// A queue of limited length that says what it does when it is full.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "config/settings.hpp"

namespace tolman::pipeline {

template <class T>
class BoundedQueue {
 public:
  BoundedQueue(std::size_t capacity, config::QueuePolicy policy)
      : capacity_(capacity), policy_(policy) {}

  /// Puts `item` in. Returns what was dropped for it: nothing, the oldest, or the item itself.
  /// With config::QueuePolicy::Block waits for room.
  std::optional<T> push(T item) {
    std::unique_lock lock(mutex_);
    if (policy_ == config::QueuePolicy::Block) {
      room_.wait(lock, [&] { return items_.size() < capacity_; });
    }
    if (items_.size() >= capacity_ && policy_ == config::QueuePolicy::DropNewest) return item;
    std::optional<T> dropped;
    if (items_.size() >= capacity_) {
      dropped = std::move(items_.front());
      items_.pop_front();
    }
    items_.push_back(std::move(item));
    return dropped;
  }

  /// The oldest item, or nothing; never waits.
  std::optional<T> pop() {
    const std::lock_guard lock(mutex_);
    if (items_.empty()) return std::nullopt;
    std::optional<T> item = std::move(items_.front());
    items_.pop_front();
    room_.notify_one();
    return item;
  }

  bool empty() const {
    const std::lock_guard lock(mutex_);
    return items_.empty();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable room_;
  std::deque<T> items_;
  std::size_t capacity_;
  config::QueuePolicy policy_;
};

}  // namespace tolman::pipeline
