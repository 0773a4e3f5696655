// SPDX-License-Identifier: BSD-3-Clause
// The one-shot links from local view cells to firing patterns, with their habituation.
#pragma once

#include <cstdint>
#include <map>

#include "spatial_cells.hpp"
#include "tolman/geometry.hpp"

namespace tolman::paper_attractor {

/// RatSLAM's rule; the defaults are those of the parameters.
struct HabituationSettings {
  double increment = 1.0;   ///< of the decay, per immediate repetition
  double recovery = 0.04;   ///< of the decay, per view
  int newest_ignored = 10;  ///< templates too new to inject
  int first_views_ignored = 50;
};

/// What one view template was linked to when it was made.
struct ViewLink {
  CellPose learned;             ///< the estimate at that moment
  std::int64_t order = 0;       ///< how many links were made before
  std::int64_t experience = 0;  ///< the experience the robot was at
  /// Pose of the template in the coordinates of that experience, by path integration.
  Eigen::Isometry3d T_experience_template = Eigen::Isometry3d::Identity();
  double decay = 1;  ///< habituation, as of view number `last_view`
  std::int64_t last_view = 0;
};

class ViewLinks {
 public:
  explicit ViewLinks(const HabituationSettings& settings) : settings_(settings) {}

  /// Called once for each view, before it is used.
  void countView() { ++views_; }
  void learn(std::int64_t template_id, ViewLink link);
  /// The robot was carried to an unknown place: no link is too new any more.
  void startPart() { settled_ = static_cast<std::int64_t>(links_.size()); }
  /// Null when the template was never seen.
  const ViewLink* find(std::int64_t template_id) const;
  /// Activates the link of a familiar view; true if it is to inject. A view that comes again and
  /// again habituates: its energy (30 - exp(1.2 decay)) / 30 falls below zero at the third time.
  bool activate(std::int64_t template_id);

 private:
  HabituationSettings settings_;
  std::map<std::int64_t, ViewLink> links_;  ///< by template id
  std::int64_t views_ = 0;
  std::int64_t previous_ = -1;
  std::int64_t settled_ = 0;  ///< number of links from before the last gap
};

}  // namespace tolman::paper_attractor
