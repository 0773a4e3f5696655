// SPDX-License-Identifier: BSD-3-Clause
// Slots of the window.
#include "window.hpp"

#include <algorithm>

namespace tolman::direct_sparse {

void Window::clear() {
  order_.clear();
  prior = Prior();
  field.clear();
  moments = ScaleMoments<double>();
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

std::vector<Eigen::Vector3d> somePositions(const Pinhole& camera, const Window& window,
                                           const Eigen::Isometry3d& T_camera_world,
                                           std::size_t most) {
  const std::size_t step = 1 + window.pointCount() / most;
  std::size_t number = 0;
  std::vector<Eigen::Vector3d> positions;
  for (const int slot : window.order()) {
    const Keyframe& host = window.keyframe(slot);
    const Eigen::Isometry3d T_camera_host = T_camera_world * host.T_world_camera();
    for (const Point& point : host.points) {
      if (number++ % step != 0) continue;
      const Eigen::Vector3d ray = camera.ray({point.u, point.v});
      positions.push_back(T_camera_host * (ray / static_cast<double>(point.inverse_depth)));
    }
  }
  return positions;
}

}  // namespace tolman::direct_sparse
