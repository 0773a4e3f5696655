// SPDX-License-Identifier: BSD-3-Clause
#include "traffic.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "tolman/geometry.hpp"

namespace tolman::town {
namespace {

Eigen::Isometry3d poseOf(const Placement& p) {
  Eigen::Isometry3d T_town_object(
      Eigen::AngleAxisd(std::atan2(static_cast<double>(p.sine), static_cast<double>(p.cosine)),
                        Eigen::Vector3d::UnitZ()));
  T_town_object.pretranslate(
      Eigen::Vector3f(p.position.x, p.position.y, p.position.z).cast<double>());
  return T_town_object;
}

}  // namespace

Traffic::Traffic(const CameraRoute& route, const StreetPlan& plan, double cars_per_km,
                 std::uint32_t seed, World& world)
    : plan_(&plan), first_(world.instances.size()) {
  constexpr double kSpacing = 1;  // m between points
  for (const Eigen::Isometry3d& T : route.T_town_camera) {
    const Eigen::Vector2d left = -T.linear().col(0).head<2>().normalized();
    const Eigen::Vector2d p = T.translation().head<2>() + 2 * StreetPlan::kLaneOffset * left;
    const double step = lane_.empty() ? 0 : (p - lane_.back().position).norm();
    if (lane_.empty() || step >= kSpacing) {
      lane_.push_back({p, lane_.empty() ? 0 : lane_.back().s + step});
    }
  }
  if (lane_.size() < 2 || route.building != Building::None) return;
  const double length = lane_.back().s;
  const auto count = static_cast<std::uint32_t>(std::lround(cars_per_km * length / 1000));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t drive = hash(seed, 301);
    const double even = length * (i + static_cast<double>(unit(hash(drive, i, 1)))) / count;
    cars_.push_back({even, 6 + 7 * static_cast<double>(unit(hash(drive, i, 2)))});
    const std::uint32_t own = hash(seed, i, 302);
    world.instances.push_back({world.cars.at(own % world.cars.size()), {}, own});
  }
}

Placement Traffic::at(std::size_t index, const Instant& now) const {
  const Car& car = cars_[index];
  const double s = wrapPeriod(car.start - car.speed * now.seconds, lane_.back().s);
  const auto next = std::lower_bound(lane_.begin() + 1, lane_.end() - 1, s,
                                     [](const LanePoint& p, double value) { return p.s < value; });
  const LanePoint& from = *std::prev(next);
  const Eigen::Vector2d along = next->position - from.position;
  const Eigen::Vector2d place = from.position + along * ((s - from.s) / (next->s - from.s));
  const Placement car_there =
      Placement::at({static_cast<float>(place.x()), static_cast<float>(place.y()),
                     static_cast<float>(plan_->height(place.x(), place.y()))},
                    static_cast<float>(std::atan2(-along.y(), -along.x())));
  return besideCamera(car_there, now.T_town_camera);
}

bool Traffic::arrange(Scene& scene, const Instant& now) const {
  for (std::size_t i = 0; i < cars_.size(); ++i) scene.move(first_ + i, at(i, now));
  return !cars_.empty();
}

void Traffic::follow(const Instant& begin, const Instant& middle, const Instant& end,
                     OpenShutter& shutter) const {
  shutter.first_object = static_cast<std::uint32_t>(first_);
  for (std::size_t i = 0; i < cars_.size(); ++i) {
    const Eigen::Isometry3d T_middle_town = poseOf(at(i, middle)).inverse();
    shutter.objects.push_back(
        {poseOf(at(i, begin)) * T_middle_town, poseOf(at(i, end)) * T_middle_town});
  }
}

Placement besideCamera(Placement car, const Eigen::Isometry3d& T_town_camera) {
  constexpr double kNear = 6;    // m ahead or behind: a car's length and a half
  constexpr double kFar = 20;    // m ahead or behind, where it begins to move aside
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
  // To the left, unless it is clearly on the right.
  const double side = beside < -0.5 * kBeside ? -kBeside : kBeside;
  const Eigen::Vector2d moved = share * (side - beside) * left;
  car.position.x += static_cast<float>(moved.x());
  car.position.y += static_cast<float>(moved.y());
  return car;
}

}  // namespace tolman::town
