// SPDX-License-Identifier: BSD-3-Clause
#include "view_links.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::paper_attractor {
namespace {
constexpr double kRestingDecay = 1.0;  // RatSLAM's; so are the limit 30 and the factor 1.2 below
}

void ViewLinks::learn(std::int64_t template_id, ViewLink link) {
  link.order = static_cast<std::int64_t>(links_.size());
  link.decay = kRestingDecay;
  link.last_view = views_;
  links_[template_id] = link;
  previous_ = template_id;
}

const ViewLink* ViewLinks::find(std::int64_t template_id) const {
  const auto found = links_.find(template_id);
  return found == links_.end() ? nullptr : &found->second;
}

bool ViewLinks::activate(std::int64_t template_id) {
  const auto found = links_.find(template_id);
  if (found == links_.end()) return false;
  ViewLink& link = found->second;
  const bool repeated = previous_ == template_id;
  previous_ = template_id;

  // All links recover at every view; the recovery is computed when a link is used.
  const auto rested = static_cast<double>(views_ - link.last_view);
  link.decay = std::max(kRestingDecay, link.decay - settings_.recovery * rested);
  link.last_view = views_;
  if (repeated) link.decay += settings_.increment;

  const auto count = static_cast<std::int64_t>(links_.size());
  const bool too_new = link.order >= std::max(settled_, count - settings_.newest_ignored);
  const bool too_early = views_ <= settings_.first_views_ignored;
  return !too_new && !too_early && std::exp(1.2 * link.decay) < 30;
}

}  // namespace tolman::paper_attractor
