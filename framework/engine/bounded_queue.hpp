// SPDX-License-Identifier: BSD-3-Clause
// A queue of limited length with a policy for a full queue.
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

  /// Adds `item`. Returns the dropped item, if any: the oldest one, or `item` itself. With
  /// config::QueuePolicy::Block waits until there is room.
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

  /// Removes and returns the oldest item; none if the queue is empty. Never waits.
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
