// SPDX-License-Identifier: BSD-3-Clause
// All that changes during a run.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "attractor_sheet.hpp"
#include "tolman/geometry.hpp"

namespace tolman::can_sheet {

/// What a view was linked to when its template was made.
struct ViewLink {
  std::vector<Phase> phases;  ///< of each module
  double heading = 0;         ///< rad
  double travel = 0;          ///< m since the start
  std::int64_t experience = -1;
  Eigen::Isometry3d T_experience_template = Eigen::Isometry3d::Identity();
};

struct SheetState {
  std::vector<AttractorSheet> sheets;  ///< one for each module, smallest period first
  double heading = 0;                  ///< rad
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m from the start, decoded
  double travel = 0;                                   ///< m since the start
  double travel_at_view = 0;                           ///< m, when a view last injected
  double travel_at_loop = 0;                           ///< m, when the last loop was closed
  std::int64_t experiences = 0;
  std::int64_t current = -1;  ///< experience that the robot is at
  Eigen::Isometry3d T_experience_current = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_made_current = Eigen::Isometry3d::Identity();  ///< from the newest experience
  bool initialising = true;  ///< odometry had no motion at the last frame
  bool new_part = false;     ///< odometry has started again, and no experience was made since
  bool relocating = false;   ///< odometry has started again, and no loop was closed since
  std::map<std::int64_t, ViewLink> links;  ///< by template id
};

}  // namespace tolman::can_sheet
