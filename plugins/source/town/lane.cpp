// SPDX-License-Identifier: BSD-3-Clause
#include "lane.hpp"

#include <algorithm>

namespace tolman::town {

Lane::Lane(const CameraRoute& route, double left_offset) {
  constexpr double kSpacing = 1;  // m between points
  for (std::size_t frame = 0; frame < route.T_town_camera.size(); ++frame) {
    const Eigen::Isometry3d& T = route.T_town_camera[frame];
    const Eigen::Vector2d left = -T.linear().col(0).head<2>().normalized();
    const Eigen::Vector2d p = T.translation().head<2>() + left_offset * left;
    const double step = points_.empty() ? 0 : (p - points_.back().position).norm();
    if (points_.empty() || step >= kSpacing) {
      points_.push_back(
          {p, points_.empty() ? 0 : points_.back().s + step, frame, T.translation().z()});
    }
  }
}

std::size_t Lane::after(double s) const {
  const auto found = std::lower_bound(points_.begin() + 1, points_.end() - 1, s,
                                      [](const Point& p, double value) { return p.s < value; });
  return static_cast<std::size_t>(found - points_.begin());
}

Lane::Position Lane::at(double s) const {
  const std::size_t next = after(s);
  const Point& to = points_[next];
  const Point& from = points_[next - 1];
  const Eigen::Vector2d along = to.position - from.position;
  return {from.position + along * ((s - from.s) / (to.s - from.s)), along, to.camera_z};
}

std::size_t Lane::frameAt(double s) const { return points_[after(s)].frame; }

}  // namespace tolman::town
