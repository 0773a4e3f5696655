// SPDX-License-Identifier: BSD-3-Clause
#include "pair_queue.hpp"

#include <utility>

namespace tolman::ros1 {

void PairQueue::add(std::deque<Arrived>& queue, Arrived image) {
  constexpr std::size_t kMax = 100;
  if (queue.size() == kMax) {
    queue.pop_front();
    ++left_out_;
  }
  queue.push_back(std::move(image));
}

std::optional<ArrivedPair> PairQueue::take() {
  while (!left_.empty() && (!pairs_ || !right_.empty())) {
    const std::int64_t later =
        pairs_ ? left_.front().stamp_ns - right_.front().stamp_ns : std::int64_t{0};
    const bool together = later <= tolerance_ns_ && -later <= tolerance_ns_;
    if (!pairs_ || together) {
      ArrivedPair pair;
      pair.left = std::move(left_.front());
      left_.pop_front();
      if (!pairs_) return pair;
      pair.right = std::move(right_.front());
      right_.pop_front();
      return pair;
    }
    (later < 0 ? left_ : right_).pop_front();
    ++left_out_;
  }
  return std::nullopt;
}

}  // namespace tolman::ros1
