// SPDX-License-Identifier: BSD-3-Clause
#include "condition_schedule.hpp"

#include <algorithm>

#include "noise.hpp"

namespace tolman::town {
namespace {

constexpr double kChange = 10;  ///< m to either side

Light lightOf(const Condition& condition, const TownParameters& p) {
  const auto seed = static_cast<std::uint32_t>(p.seed);
  Light light = makeLight(condition.hour.value_or(p.hour), condition.weather.value_or(p.weather),
                          p.haze, hash(seed, 303));
  if (condition.is_night) makeNight(light);
  light.wet = light.rain = condition.rains ? 1 : 0;
  light.snow = condition.snow ? 1 : 0;
  return light;
}

}  // namespace

Result<ConditionSchedule> ConditionSchedule::make(const TownParameters& parameters,
                                                  const CameraRoute& route) {
  const Result<std::vector<ConditionEntry>> entries = parseConditions(parameters.conditions);
  if (!entries.isOk()) return entries.status();
  ConditionSchedule schedule;
  schedule.conditions_ = conditionsOf(route, entries.value(), schedule.warnings_);
  schedule.driven_ = drivenMetres(route);
  for (const Condition& condition : schedule.conditions_) {
    schedule.lights_.push_back(lightOf(condition, parameters));
  }
  return schedule;
}

Light ConditionSchedule::lightAt(std::size_t frame) const {
  std::size_t first = frame;
  std::size_t end = frame + 1;
  while (first > 0 && driven_[frame] - driven_[first - 1] <= kChange) --first;
  while (end < driven_.size() && driven_[end] - driven_[frame] <= kChange) ++end;
  const auto here = conditions_.begin() + static_cast<std::ptrdiff_t>(frame);
  const bool is_one = std::all_of(conditions_.begin() + static_cast<std::ptrdiff_t>(first),
                                  conditions_.begin() + static_cast<std::ptrdiff_t>(end),
                                  [&](const Condition& c) { return c == *here; });
  return is_one ? lights_[frame] : meanOf({lights_.data() + first, end - first});
}

bool ConditionSchedule::anyBare() const {
  return std::any_of(conditions_.begin(), conditions_.end(),
                     [](const Condition& c) { return c.bare; });
}

bool ConditionSchedule::anyExchanged() const {
  return std::any_of(conditions_.begin(), conditions_.end(),
                     [](const Condition& c) { return c.exchanged; });
}

}  // namespace tolman::town
