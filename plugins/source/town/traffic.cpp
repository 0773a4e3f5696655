// SPDX-License-Identifier: BSD-3-Clause
#include "traffic.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "tolman/geometry.hpp"

namespace tolman::town {

Traffic::Traffic(const CameraRoute& route, const StreetPlan& plan, double cars_per_km,
                 std::uint32_t seed)
    : plan_(&plan) {
  constexpr double kSpacing = 1;  // m between points of the lane
  for (const Eigen::Isometry3d& T : route.T_town_camera) {
    const Eigen::Vector2d left = -T.linear().col(0).head<2>().normalized();
    const Eigen::Vector2d p = T.translation().head<2>() + 2 * StreetPlan::kLaneOffset * left;
    const double step = lane_.empty() ? 0 : (p - lane_.back().position).norm();
    if (lane_.empty() || step >= kSpacing) {
      lane_.push_back({p, lane_.empty() ? 0 : lane_.back().s + step});
    }
  }
  const double length = lane_.back().s;
  if (lane_.size() < 2) return;
  const auto count = static_cast<std::uint32_t>(std::lround(cars_per_km * length / 1000));
  for (std::uint32_t i = 0; i < count; ++i) {
    const double even = length * (i + static_cast<double>(unit(hash(seed, i, 1)))) / count;
    cars_.push_back({even, 6 + 7 * static_cast<double>(unit(hash(seed, i, 2)))});
  }
}

Placement Traffic::at(std::size_t index, double seconds) const {
  const Car& car = cars_[index];
  const double s = wrapPeriod(car.start - car.speed * seconds, lane_.back().s);
  const auto after = std::lower_bound(lane_.begin() + 1, lane_.end() - 1, s,
                                      [](const LanePoint& p, double value) { return p.s < value; });
  const LanePoint& to = *after;
  const LanePoint& from = *(after - 1);
  const Eigen::Vector2d along = to.position - from.position;
  const Eigen::Vector2d p = from.position + along * ((s - from.s) / (to.s - from.s));
  const double yaw = std::atan2(-along.y(), -along.x());
  return Placement::at({static_cast<float>(p.x()), static_cast<float>(p.y()),
                        static_cast<float>(plan_->height(p.x(), p.y()))},
                       static_cast<float>(yaw));
}

Placement besideCamera(Placement car, const Eigen::Isometry3d& T_town_camera) {
  constexpr double kNear = 6;    // m ahead or behind: a car's length and a half
  constexpr double kFar = 20;    // m, from here on it moves over
  constexpr double kBeside = 3;  // m between the centrelines
  const Eigen::Vector2d forward = T_town_camera.linear().col(2).head<2>().normalized();
  const Eigen::Vector2d left(-forward.y(), forward.x());
  const Eigen::Vector2d camera = T_town_camera.translation().head<2>();
  const Eigen::Vector2d offset =
      Eigen::Vector2d(static_cast<double>(car.position.x), static_cast<double>(car.position.y)) -
      camera;
  const double ahead = std::fabs(offset.dot(forward));
  const double beside = offset.dot(left);
  if (ahead >= kFar || std::fabs(beside) >= kBeside) return car;
  const double share = std::min(1.0, (kFar - ahead) / (kFar - kNear));
  const double side = beside < -0.5 * kBeside ? -kBeside : kBeside;  // to the left, if not right
  const Eigen::Vector2d moved = share * (side - beside) * left;
  car.position.x += static_cast<float>(moved.x());
  car.position.y += static_cast<float>(moved.y());
  return car;
}

}  // namespace tolman::town
