// SPDX-License-Identifier: BSD-3-Clause
// Book-keeping of the active window.
#include "window.hpp"

namespace tolman::feature_stereo {

void Window::clear() {
  keyframes_.clear();
  landmarks_.clear();
}

void Window::dropOldest() {
  const std::int64_t oldest = keyframes_.front().frame;
  keyframes_.pop_front();
  for (auto& [id, landmark] : landmarks_) {
    std::erase_if(landmark.observations,
                  [oldest](const Observation& seen) { return seen.keyframe == oldest; });
  }
  dropUnseen();
}

void Window::dropUnseen() {
  std::erase_if(landmarks_, [](const auto& entry) { return entry.second.observations.empty(); });
}

std::int64_t Window::addLandmark(const Landmark& landmark) {
  landmarks_.emplace(next_id_, landmark);
  return next_id_++;
}

Landmark* Window::find(std::int64_t id) {
  const auto found = landmarks_.find(id);
  return found == landmarks_.end() ? nullptr : &found->second;
}

std::size_t Window::indexOf(std::int64_t frame) const {
  std::size_t index = 0;
  while (keyframes_[index].frame != frame) ++index;
  return index;
}

}  // namespace tolman::feature_stereo
