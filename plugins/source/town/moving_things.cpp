// SPDX-License-Identifier: BSD-3-Clause
#include "moving_things.hpp"

#include <algorithm>

#include "noise.hpp"
#include "people.hpp"

namespace tolman::town {
namespace {

constexpr Clearing kPassCyclist = {3, 12, 1.3};

std::vector<Eigen::Vector2d> parkedCars(const World& world) {
  std::vector<Eigen::Vector2d> places;
  for (const MeshInstance& instance : world.instances) {
    if (std::find(world.cars.begin(), world.cars.end(), instance.prototype) != world.cars.end()) {
      places.emplace_back(static_cast<double>(instance.placement.position.x),
                          static_cast<double>(instance.placement.position.y));
    }
  }
  return places;
}

/// The route up to the first building that it enters, because vehicles drive only on streets.
CameraRoute withoutBuildings(const CameraRoute& route) {
  if (route.building != Building::CarPark) return route;
  CameraRoute street;
  for (std::size_t i = 0; i < route.T_town_camera.size() && !route.isRaised(i); ++i) {
    street.stamps_ns.push_back(route.stamps_ns[i]);
    street.T_town_camera.push_back(route.T_town_camera[i]);
  }
  return street;
}

double metresFrom(const Eigen::Isometry3d& T_town_camera, const Vec3& place) {
  const Eigen::Vector3d& camera = T_town_camera.translation();
  return std::hypot(static_cast<double>(place.x) - camera.x(),
                    static_cast<double>(place.y) - camera.y());
}

}  // namespace

MovingThings::MovingThings(const TownParameters& p, const CameraRoute& whole,
                           const StreetPlan& plan, World& world)
    : MovingThings(p, plan, world, withoutBuildings(whole)) {}

MovingThings::MovingThings(const TownParameters& p, const StreetPlan& plan, World& world,
                           const CameraRoute& route)
    : headlights_(p.traffic_headlights),
      traffic_(route, plan, p.traffic, hash(static_cast<std::uint32_t>(p.seed), 301)),
      crossing_(route, plan, p.crossing_traffic, hash(static_cast<std::uint32_t>(p.seed), 305)),
      cyclists_(route, plan, p.cyclists, hash(static_cast<std::uint32_t>(p.seed), 306)),
      wind_(world, p.wind, hash(static_cast<std::uint32_t>(p.seed), 308)) {
  const auto seed = static_cast<std::uint32_t>(p.seed);
  if (p.pedestrians > 0) {
    pedestrians_.emplace(pavementRuns(plan, parkedCars(world)), plan, p.pedestrians,
                         hash(seed, 307));
    walkers_ = addWalkers(world);
  }
  if (cyclists_.size() > 0) pedals_ = addCyclists(world);
  const auto add = [&](std::uint32_t prototype, std::uint32_t own, bool shines) {
    world.instances.push_back({prototype, {}, own, shines});
  };
  first_car_ = world.instances.size();
  for (std::uint32_t i = 0; i < traffic_.size() + crossing_.size(); ++i) {
    const std::uint32_t own = hash(seed, i, 302);
    add(world.cars.at(own % world.cars.size()), own, headlights_);
  }
  first_cyclist_ = world.instances.size();
  for (std::uint32_t i = 0; i < cyclists_.size(); ++i) add(pedals_[0], hash(seed, i, 309), false);
  first_pedestrian_ = world.instances.size();
  for (std::uint32_t i = 0; pedestrians_ && i < pedestrians_->size(); ++i) {
    add(walkers_[0], hash(seed, i, 310), false);
  }
}

void MovingThings::arrangeCars(Scene& scene, double seconds,
                               const Eigen::Isometry3d& T_town_camera) {
  cars_.clear();
  for (std::size_t i = 0; i < traffic_.size(); ++i) {
    cars_.push_back(besideCamera(traffic_.at(i, seconds), T_town_camera));
    scene.move(first_car_ + i, cars_.back());
  }
  for (std::size_t i = 0; i < crossing_.size(); ++i) {
    const std::size_t instance = first_car_ + traffic_.size() + i;
    const std::optional<Placement> place = crossing_.at(i, seconds);
    scene.show(instance, place.has_value());
    if (!place) continue;
    cars_.push_back(besideCamera(*place, T_town_camera));
    scene.move(instance, cars_.back());
  }
}

void MovingThings::arrangePeople(Scene& scene, double seconds,
                                 const Eigen::Isometry3d& T_town_camera) {
  for (std::size_t i = 0; i < cyclists_.size(); ++i) {
    const auto [placement, phase] = cyclists_.at(i, seconds);
    scene.change(first_cyclist_ + i, pedals_[static_cast<std::size_t>(phase)]);
    scene.move(first_cyclist_ + i, besideCamera(placement, T_town_camera, kPassCyclist));
  }
  for (std::size_t i = 0; pedestrians_ && i < pedestrians_->size(); ++i) {
    const auto [placement, phase] = pedestrians_->at(i, seconds);
    scene.change(first_pedestrian_ + i, walkers_[static_cast<std::size_t>(phase)]);
    scene.move(first_pedestrian_ + i, placement);
  }
}

bool MovingThings::arrange(Scene& scene, double seconds, const Eigen::Isometry3d& T_town_camera) {
  arrangeCars(scene, seconds, T_town_camera);
  arrangePeople(scene, seconds, T_town_camera);
  for (const Wind::Plant& plant : wind_.plants()) {
    scene.move(plant.instance, wind_.at(plant, seconds));
  }
  return !wind_.plants().empty() || traffic_.size() + crossing_.size() + cyclists_.size() > 0 ||
         (pedestrians_ && pedestrians_->size() > 0);
}

void MovingThings::addHeadlights(Light& light, const Eigen::Isometry3d& T_town_camera) const {
  if (!headlights_) return;
  std::vector<Placement> near = cars_;
  const auto away = [&](const Placement& p) { return metresFrom(T_town_camera, p.position); };
  std::stable_sort(near.begin(), near.end(),
                   [&](const Placement& a, const Placement& b) { return away(a) < away(b); });
  light.oncoming_count = 0;
  for (const Placement& car : near) {
    if (light.oncoming_count == Light::kMaxOncoming || away(car) > 80) break;
    const Vec3 ahead = car.rotate({1, 0, 0});
    light.oncoming[static_cast<std::size_t>(light.oncoming_count++)] = {
        car.position + ahead * 2.1F + Vec3{0, 0, 0.62F}, ahead};
  }
}

}  // namespace tolman::town
