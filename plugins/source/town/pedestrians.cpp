// SPDX-License-Identifier: BSD-3-Clause
#include "pedestrians.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "tolman/geometry.hpp"

namespace tolman::town {
namespace {

constexpr double kStride = 1.4;          ///< m, left and right step of an adult
constexpr double kStandingShare = 0.15;  ///< of the people
constexpr double kChildShare = 0.15;

double draw(std::uint32_t seed, std::uint32_t what, double low, double high) {
  return low + (high - low) * static_cast<double>(unit(hash(seed, what)));
}

}  // namespace

Pedestrians::Pedestrians(std::vector<PavementRun> runs, const StreetPlan& plan,
                         double people_per_km, std::uint32_t seed)
    : plan_(&plan), runs_(std::move(runs)) {
  std::vector<double> ends;  // ends of the runs, placed one after the other
  double total = 0;
  for (const PavementRun& run : runs_) ends.push_back(total += run.length());
  double streets = 0;
  for (const StreetSection& section : plan.sections()) streets += section.points.back().s;
  if (total <= 0) return;
  const auto count = static_cast<std::uint32_t>(std::lround(people_per_km * streets / 1000));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t own = hash(seed, i, 1);
    const double at = total * (i + static_cast<double>(unit(hash(own, 2)))) / count;
    Person person;
    while (person.run + 1 < ends.size() && ends[person.run] < at) ++person.run;
    person.run_length = runs_[person.run].length();
    person.start = at - (ends[person.run] - person.run_length);
    person.size =
        draw(own, 3, 0, 1) < kChildShare ? draw(own, 4, 0.62, 0.85) : draw(own, 4, 0.92, 1.06);
    person.waits = draw(own, 5, 3, 15);
    const bool stands = draw(own, 6, 0, 1) < kStandingShare;
    person.speed = stands ? 0 : draw(own, 7, 1.0, 1.6);
    people_.push_back(person);
  }
}

Pedestrians::Posture Pedestrians::at(std::size_t index, double seconds) const {
  const Person& person = people_[index];
  const PavementRun& run = runs_[person.run];
  double s = person.start;
  double sign = 0;  // direction of the walk along the run; 0 stands
  if (person.speed > 0) {
    const double walk = person.run_length / person.speed;
    const double t = wrapPeriod(seconds + person.start / person.speed, 2 * (walk + person.waits));
    const double back = t - walk - person.waits;  // s since the beginning of the way back
    sign = t < walk ? 1 : (back >= 0 && back < walk ? -1 : 0);
    s = person.speed * (t < walk ? t : walk - std::clamp(back, 0.0, walk));
  }
  const PavementRun::Position place = run.at(s);
  const Eigen::Vector2d to_road =
      (run.is_left ? -1 : 1) * Eigen::Vector2d(-place.along.y(), place.along.x());
  const Eigen::Vector2d facing = sign == 0 ? to_road : Eigen::Vector2d(sign * place.along);
  const auto height = static_cast<float>(plan_->height(place.position.x(), place.position.y()) +
                                         StreetPlan::kKerbHeight);
  Posture posture;
  posture.placement = Placement::at(
      {static_cast<float>(place.position.x()), static_cast<float>(place.position.y()), height},
      static_cast<float>(std::atan2(facing.y(), facing.x())), static_cast<float>(person.size));
  if (sign != 0) {
    const double strides = wrapPeriod(sign * s / (kStride * person.size), 1.0);
    posture.phase = std::min(static_cast<int>(strides * kGaitPhases), kGaitPhases - 1);
  }
  return posture;
}

}  // namespace tolman::town
