// SPDX-License-Identifier: BSD-3-Clause
// All that the plugin knows: the two networks, the links of views, the experiences, the path.
#pragma once

#include "experience_log.hpp"
#include "path_memory.hpp"
#include "relocation.hpp"
#include "spatial_cells.hpp"
#include "view_evidence.hpp"
#include "view_links.hpp"

namespace tolman::bayesian_attractor {

struct AttractorState {
  SpatialCells cells;
  ViewLinks links;
  ExperienceLog log;
  PathMemory path;
  ViewEvidence evidence;
  Relocation relocation;
  bool initialising = false;  ///< odometry had no motion yet
};

}  // namespace tolman::bayesian_attractor
