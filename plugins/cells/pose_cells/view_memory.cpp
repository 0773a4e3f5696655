// SPDX-License-Identifier: BSD-3-Clause
#include "view_memory.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::pose_cells {

std::optional<ViewMemory::Injection> ViewMemory::see(std::int64_t template_id,
                                                     const CellPose& here) {
  ++seen_;
  const bool repeated = template_id == previous_;
  previous_ = template_id;
  const auto count = static_cast<std::int64_t>(views_.size());
  const auto [place, fresh] = views_.try_emplace(template_id);
  View& view = place->second;
  if (fresh) {
    view = {here, count, settings_.resting_decay, seen_};
    return std::nullopt;
  }
  // All views recover with each view; counted only when one is looked at.
  const auto rested = static_cast<double>(seen_ - view.last_seen);
  view.decay = std::max(settings_.resting_decay, view.decay - settings_.restore * rested);
  view.last_seen = seen_;
  if (repeated) view.decay += settings_.resting_decay;
  if (view.order >= count - settings_.newest_ignored) return std::nullopt;  // signed: small counts
  const double energy = settings_.energy * (30 - std::exp(1.2 * view.decay)) / 30;
  if (!(energy > 0)) return std::nullopt;
  return Injection{view.place, energy};
}

}  // namespace tolman::pose_cells
