// SPDX-License-Identifier: BSD-3-Clause
// Slots of the window.
#include "window.hpp"

#include <algorithm>

namespace tolman::direct_sparse {

void Window::clear() {
  order_.clear();
  prior = Prior();
  offset = DisparityOffset();
  energy_threshold = kFirstThreshold;
}

const Keyframe* Window::find(std::int64_t frame) const {
  for (const int slot : order_) {
    if (keyframe(slot).frame == frame) return &keyframe(slot);
  }
  return nullptr;
}

Keyframe& Window::add() {
  int slot = 0;
  while (std::find(order_.begin(), order_.end(), slot) != order_.end()) ++slot;
  Keyframe& made = keyframes_.at(static_cast<std::size_t>(slot));
  order_.push_back(slot);
  made.points.clear();
  made.immature.clear();
  made.points_made = 0;
  made.change.setZero();
  made.affine0 = Affine();
  made.has_prior = false;
  made.has_right = false;
  return made;
}

void Window::remove(int slot) {
  std::erase(order_, slot);
  const auto index = static_cast<std::size_t>(slot);
  for (const int other : order_) {
    for (Point& point : keyframe(other).points) point.temporal[index] = ResidualState::Absent;
  }
}

std::size_t Window::pointCount() const {
  std::size_t count = 0;
  for (const int slot : order_) count += keyframe(slot).points.size();
  return count;
}

}  // namespace tolman::direct_sparse
