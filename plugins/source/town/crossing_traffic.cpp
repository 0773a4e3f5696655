// SPDX-License-Identifier: BSD-3-Clause
#include "crossing_traffic.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "street_path.hpp"
#include "traffic.hpp"

namespace tolman::town {
namespace {

constexpr double kMeets = 3;            ///< m between two passes that cross
constexpr double kLargestCosine = 0.7;  ///< of the angle between their directions
constexpr double kStopsBefore = 10;     ///< m from the middle of the car to the camera's path
constexpr double kArm = 22;             ///< m of side street that must not be the camera's
constexpr double kClearOfCamera = 6;    ///< m, between them
constexpr double kSpeed = 7;            ///< m/s
constexpr double kBrakes = 2;           ///< m/s^2
constexpr double kStarts = 1.5;         ///< m/s^2
constexpr double kShown = 15;           ///< s before it stops and after it leaves

double nearestTo(const Lane& way, const Eigen::Vector2d& place, double from, double to) {
  double nearest = 1e9;
  for (double s = std::max(from, 0.0); s <= std::min(to, way.length()); s += 1) {
    nearest = std::min(nearest, (way.at(s).position - place).norm());
  }
  return nearest;
}

}  // namespace

std::vector<CrossingTraffic::Junction> CrossingTraffic::junctions() const {
  PointGrid grid;
  std::vector<Lane::Position> places;
  for (double s = 0; s < way_.length(); s += 1) {
    places.push_back(way_.at(s));
    grid.add(places.back().position, places.size() - 1);
  }
  std::vector<Junction> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::vector<std::size_t> near = grid.near(places[i].position);
    std::sort(near.begin(), near.end());
    for (const std::size_t j : near) {
      const auto s = static_cast<double>(i);
      const auto other_s = static_cast<double>(j);
      const double cosine = places[i].along.normalized().dot(places[j].along.normalized());
      const bool crosses = std::abs(s - other_s) > kOtherPass &&
                           std::abs(cosine) < kLargestCosine &&
                           (places[i].position - places[j].position).norm() < kMeets;
      const bool is_known = std::any_of(found.begin(), found.end(), [&](const Junction& known) {
        return std::abs(known.s - s) < kArm && std::abs(known.other_s - other_s) < kArm;
      });
      if (crosses && !is_known) found.push_back({s, other_s});
    }
  }
  return found;
}

std::optional<CrossingTraffic::Car> CrossingTraffic::carAt(const Junction& junction, bool comes,
                                                           double passes_at) const {
  const double sign = comes ? 1 : -1;  // direction from the junction into the side street
  const double arm_s = junction.other_s + sign * kArm;
  if (arm_s < 0 || arm_s > way_.length()) return std::nullopt;
  const Eigen::Vector2d arm = way_.at(arm_s).position;
  if (nearestTo(way_, arm, junction.s - 2 * kArm, junction.s + 2 * kArm) < kClearOfCamera) {
    return std::nullopt;
  }
  Car car;
  car.comes = comes;
  // Parallel lanes differ in length, so the stop is found from its position on the camera's lane.
  const Eigen::Vector2d at = way_.at(junction.other_s + sign * kStopsBefore).position;
  car.stop_s = junction.other_s + sign * kStopsBefore;
  if (comes) {
    double nearest = 1e9;
    for (double s = 0; s < oncoming_.length(); s += 0.5) {
      const double apart = (oncoming_.at(s).position - at).norm();
      const double frames = std::abs(static_cast<double>(oncoming_.frameAt(s)) -
                                     static_cast<double>(way_.frameAt(car.stop_s)));
      if (frames > 60 || apart >= nearest) continue;
      nearest = apart;
      car.stop_s = s;
    }
    if (nearest > 6) return std::nullopt;
  }
  car.arrives = passes_at - 2;
  car.leaves = passes_at + 1.5;
  return car;
}

CrossingTraffic::CrossingTraffic(const CameraRoute& route, const StreetPlan& plan, double share,
                                 std::uint32_t seed)
    : plan_(&plan), way_(route, 0), oncoming_(route, 2 * StreetPlan::kLaneOffset) {
  if (share <= 0 || way_.isEmpty() || oncoming_.isEmpty()) return;
  std::uint32_t number = 0;
  for (const Junction& junction : junctions()) {
    const std::size_t frame = way_.frameAt(junction.s);
    const double passes_at =
        static_cast<double>(route.stamps_ns[frame] - route.stamps_ns.front()) * 1e-9;
    for (const bool comes : {false, true}) {
      const std::uint32_t own = hash(seed, number++);
      if (static_cast<double>(unit(own)) >= share) continue;
      std::optional<Car> car = carAt(junction, comes, passes_at);
      if (!car) continue;
      car->arrives -= 4 * static_cast<double>(unit(hash(own, 1)));
      car->leaves += 2 * static_cast<double>(unit(hash(own, 2)));
      cars_.push_back(*car);
    }
  }
}

std::optional<Placement> CrossingTraffic::at(std::size_t index, double seconds) const {
  const Car& car = cars_[index];
  if (seconds < car.arrives - kShown || seconds > car.leaves + kShown) return std::nullopt;
  double driven = 0;  // m after the stop
  if (seconds < car.arrives) {
    const double left = car.arrives - seconds;
    const double braking = std::min(left, kSpeed / kBrakes);
    driven = -kBrakes * braking * braking / 2 - kSpeed * (left - braking);
  } else if (seconds > car.leaves) {
    const double since = seconds - car.leaves;
    const double starting = std::min(since, kSpeed / kStarts);
    driven = kStarts * starting * starting / 2 + kSpeed * (since - starting);
  }
  const Lane& lane = car.comes ? oncoming_ : way_;
  const double s = car.stop_s + (car.comes ? -driven : driven);
  if (s < 0 || s > lane.length()) return std::nullopt;
  const Lane::Position place = lane.at(s);
  return onRoad(*plan_, place, car.comes);
}

}  // namespace tolman::town
