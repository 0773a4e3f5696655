// SPDX-License-Identifier: BSD-3-Clause
#include "traffic.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "tolman/geometry.hpp"

namespace tolman::town {

Traffic::Traffic(const CameraRoute& route, const StreetPlan& plan, double cars_per_km,
                 std::uint32_t seed)
    : plan_(&plan), lane_(route, 2 * StreetPlan::kLaneOffset) {
  if (lane_.isEmpty()) return;
  const double length = lane_.length();
  const auto count = static_cast<std::uint32_t>(std::lround(cars_per_km * length / 1000));
  for (std::uint32_t i = 0; i < count; ++i) {
    const double even = length * (i + static_cast<double>(unit(hash(seed, i, 1)))) / count;
    cars_.push_back({even, 6 + 7 * static_cast<double>(unit(hash(seed, i, 2)))});
  }
}

Placement Traffic::at(std::size_t index, double seconds) const {
  const Car& car = cars_[index];
  const Lane::Position place =
      lane_.at(wrapPeriod(car.start - car.speed * seconds, lane_.length()));
  return onRoad(*plan_, place, true);
}

Placement onRoad(const StreetPlan& plan, const Lane::Position& place, bool comes) {
  const Eigen::Vector2d forward = comes ? Eigen::Vector2d(-place.along) : place.along;
  const double yaw = std::atan2(forward.y(), forward.x());
  const Eigen::Vector2d& at = place.position;
  return Placement::at({static_cast<float>(at.x()), static_cast<float>(at.y()),
                        static_cast<float>(plan.roadHeight(at.x(), at.y(), place.camera_z))},
                       static_cast<float>(yaw));
}

Placement besideCamera(Placement car, const Eigen::Isometry3d& T_town_camera,
                       const Clearing& clearing) {
  const Eigen::Vector2d forward = T_town_camera.linear().col(2).head<2>().normalized();
  const Eigen::Vector2d left(-forward.y(), forward.x());
  const Eigen::Vector2d camera = T_town_camera.translation().head<2>();
  const Eigen::Vector2d offset =
      Eigen::Vector2d(static_cast<double>(car.position.x), static_cast<double>(car.position.y)) -
      camera;
  const double ahead = std::fabs(offset.dot(forward));
  const double beside = offset.dot(left);
  if (ahead >= clearing.far || std::fabs(beside) >= clearing.beside) return car;
  const double share = std::min(1.0, (clearing.far - ahead) / (clearing.far - clearing.near));
  const double side =  // to the left, unless it is clearly on the right
      beside < -0.5 * clearing.beside ? -clearing.beside : clearing.beside;
  const Eigen::Vector2d moved = share * (side - beside) * left;
  car.position.x += static_cast<float>(moved.x());
  car.position.y += static_cast<float>(moved.y());
  return car;
}

}  // namespace tolman::town
