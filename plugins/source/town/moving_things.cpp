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

/// Motion of an object, in the town's axes, from one placement to another.
Eigen::Isometry3d between(const Placement& from, const Placement& to) {
  const auto poseOf = [](const Placement& p) {
    Eigen::Isometry3d T_town_object(
        Eigen::AngleAxisd(std::atan2(static_cast<double>(p.sine), static_cast<double>(p.cosine)),
                          Eigen::Vector3d::UnitZ()));
    T_town_object.pretranslate(
        Eigen::Vector3f(p.position.x, p.position.y, p.position.z).cast<double>());
    return T_town_object;
  };
  return poseOf(to) * poseOf(from).inverse();
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
  first_ = world.instances.size();
  for (std::uint32_t i = 0; i < traffic_.size() + crossing_.size(); ++i) {
    const std::uint32_t own = hash(seed, i, 302);
    add(world.cars.at(own % world.cars.size()), own, headlights_);
  }
  for (std::uint32_t i = 0; i < cyclists_.size(); ++i) add(pedals_[0], hash(seed, i, 309), false);
  for (std::uint32_t i = 0; pedestrians_ && i < pedestrians_->size(); ++i) {
    add(walkers_[0], hash(seed, i, 310), false);
  }
}

std::vector<MovingThings::Pose> MovingThings::posesAt(const Instant& now) const {
  const auto& [seconds, T_town_camera] = now;
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < traffic_.size(); ++i) {
    poses.push_back({besideCamera(traffic_.at(i, seconds), T_town_camera), {}});
  }
  for (std::size_t i = 0; i < crossing_.size(); ++i) {
    std::optional<Placement> place = crossing_.at(i, seconds);
    if (place) place = besideCamera(*place, T_town_camera);
    poses.push_back({place, {}});
  }
  for (std::size_t i = 0; i < cyclists_.size(); ++i) {
    const auto [placement, phase] = cyclists_.at(i, seconds);
    poses.push_back({besideCamera(placement, T_town_camera, kPassCyclist),
                     pedals_[static_cast<std::size_t>(phase)]});
  }
  for (std::size_t i = 0; pedestrians_ && i < pedestrians_->size(); ++i) {
    const auto [placement, phase] = pedestrians_->at(i, seconds);
    poses.push_back({placement, walkers_[static_cast<std::size_t>(phase)]});
  }
  return poses;
}

bool MovingThings::arrange(Scene& scene, const Instant& now) {
  arranged_ = posesAt(now);
  for (std::size_t i = 0; i < arranged_.size(); ++i) {
    const auto& [placement, prototype] = arranged_[i];
    scene.show(first_ + i, placement.has_value());
    if (!placement) continue;
    if (prototype) scene.change(first_ + i, *prototype);
    scene.move(first_ + i, *placement);
  }
  for (const Wind::Plant& plant : wind_.plants()) {
    scene.move(plant.instance, wind_.at(plant, now.seconds));
  }
  return !wind_.plants().empty() || !arranged_.empty();
}

void MovingThings::follow(const Instant& begin, const Instant& end, OpenShutter& shutter) const {
  const std::vector<Pose> at_begin = posesAt(begin);
  const std::vector<Pose> at_end = posesAt(end);
  shutter.first_object = static_cast<std::uint32_t>(first_);
  shutter.objects.assign(arranged_.size(), {});
  for (std::size_t i = 0; i < arranged_.size(); ++i) {
    const std::optional<Placement>& middle = arranged_[i].placement;
    if (!at_begin[i].placement || !middle || !at_end[i].placement) continue;
    shutter.objects[i] = {between(*middle, *at_begin[i].placement),
                          between(*middle, *at_end[i].placement)};
  }
}

void MovingThings::addHeadlights(Light& light, const Eigen::Isometry3d& T_town_camera) const {
  if (!headlights_) return;
  std::vector<Placement> near;
  for (std::size_t i = 0; i < traffic_.size() + crossing_.size(); ++i) {
    if (arranged_[i].placement) near.push_back(*arranged_[i].placement);
  }
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
