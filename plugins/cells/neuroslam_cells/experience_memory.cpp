// SPDX-License-Identifier: BSD-3-Clause
#include "experience_memory.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::neuroslam_cells {
namespace {

double shortWay(double a, double b, double period) { return std::remainder(b - a, period); }

}  // namespace

double distance(const ConjunctivePlace& a, const ConjunctivePlace& b, const Periods& periods) {
  const double x = shortWay(a.x, b.x, periods.side);
  const double y = shortWay(a.y, b.y, periods.side);
  const double height = shortWay(a.height, b.height, periods.side);
  return std::hypot(std::hypot(x, y, height), shortWay(a.heading, b.heading, periods.headings));
}

Action ExperienceMemory::create(const ConjunctivePlace& place, std::int64_t template_id) {
  current_ = static_cast<std::int64_t>(places_.size());
  places_.push_back(place);
  if (template_id >= 0) of_template_[template_id].push_back(current_);
  return Action::CreateExperience;
}

Action ExperienceMemory::decide(const ConjunctivePlace& here, std::int64_t template_id) {
  const bool changed = template_id != previous_template_;
  previous_template_ = template_id;
  const auto attached = of_template_.find(template_id);
  if (current_ < 0 || attached == of_template_.end()) return create(here, template_id);
  const auto away = [&](std::int64_t id) {
    return distance(here, places_[static_cast<std::size_t>(id)], periods_);
  };
  if (!changed && away(current_) <= threshold_) return Action::Stay;
  const std::int64_t nearest = *std::ranges::min_element(attached->second, {}, away);
  if (away(nearest) >= threshold_) return create(here, template_id);
  if (nearest == current_) return Action::Stay;
  current_ = nearest;
  return Action::CloseLoop;
}

}  // namespace tolman::neuroslam_cells
