// SPDX-License-Identifier: BSD-3-Clause
#include "experience_memory.hpp"

#include "tolman/geometry.hpp"

namespace tolman::pose_cells {

Action ExperienceMemory::create(const CellPose& place, std::int64_t template_id) {
  current_ = static_cast<std::int64_t>(experiences_.size());
  experiences_.push_back({place, template_id});
  if (template_id >= 0) of_template_[template_id].push_back(current_);
  return Action::CreateExperience;
}

void ExperienceMemory::createFirst(const CellPose& here) { create(here, -1); }

Action ExperienceMemory::decide(const ActivityVolume& volume, const CellPose& here, double turned,
                                std::int64_t template_id) {
  const bool changed = template_id != previous_template_;
  previous_template_ = template_id;
  // The pose at which the robot looks as in the template: without the view's turn against it.
  CellPose straight = here;
  straight.theta = wrapPeriod(here.theta - turned, volume.headings());
  const auto attached = of_template_.find(template_id);
  if (current_ < 0 || attached == of_template_.end()) return create(straight, template_id);

  const CellPose& present = experiences_[static_cast<std::size_t>(current_)].place;
  if (!changed && volume.distance(straight, present) <= threshold_) return Action::Stay;
  std::int64_t nearest = -1;
  double least = threshold_;
  for (const std::int64_t id : attached->second) {
    const double away = volume.distance(straight, experiences_[static_cast<std::size_t>(id)].place);
    if (away >= least) continue;
    least = away;
    nearest = id;
  }
  if (nearest < 0) return create(straight, template_id);
  if (nearest == current_) return Action::Stay;
  current_ = nearest;
  return Action::CloseLoop;
}

}  // namespace tolman::pose_cells
