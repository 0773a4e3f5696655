// SPDX-License-Identifier: BSD-3-Clause
// Loops that become known later: a visit is inserted into the chain at an earlier frame.
#include <algorithm>

#include "experience_chain.hpp"

namespace tolman::experience_map {

/// Updates all references to anchors after an anchor was inserted at index `i`.
void ExperienceChain::renumber(DeadReckoning& path, std::size_t i) {
  for (std::size_t& created : of_experience_) created += created >= i ? 1 : 0;
  for (std::size_t& begin : begins_) begin += begin >= i ? 1 : 0;
  last_visit_ = last_visit_ >= i ? last_visit_ + 1 : i;
  const auto before = static_cast<std::int64_t>(i) - 1;
  for (std::size_t slot = anchors_[i].slot; slot < path.size(); ++slot) {
    const std::int64_t anchor = path[slot].anchor;
    if (anchor >= before) path.moveTo(slot, anchor + 1);
  }
}

void ExperienceChain::insertVisit(DeadReckoning& path, std::size_t slot, std::int64_t experience,
                                  const UncertainPose& measured) {
  const auto i = static_cast<std::size_t>(path[slot].anchor) + 1;
  const Anchor before = anchors_[i - 1];
  if (before.slot == slot && before.visit) return;  // this frame has a loop already
  Anchor visit;
  visit.slot = slot;
  visit.experience = experience;
  visit.visit = true;
  visit.offset = withModel(measured);
  measured_ = true;
  visit.odometry = path.between(before.slot, slot);
  visit.correction = before.correction;
  anchors_.insert(anchors_.begin() + static_cast<std::ptrdiff_t>(i), visit);
  renumber(path, i);
  if (i + 1 < anchors_.size() && !anchors_[i + 1].gap) {
    anchors_[i + 1].odometry = path.between(slot, anchors_[i + 1].slot);
  }
  countLinks();
  pending_ = true;
  if (begins_.size() == 1) return;
  anchors_[i].offset_weight = 0;  // for the parts without this visit
  const PathParts without = parts();
  anchors_[i].offset_weight = 1;
  alignPart(path, without, i);
}

}  // namespace tolman::experience_map
