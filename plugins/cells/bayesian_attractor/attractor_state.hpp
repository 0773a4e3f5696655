// SPDX-License-Identifier: BSD-3-Clause
// All that the plugin knows: the two networks, the links of views, the experiences, the path.
#pragma once

#include "experience_log.hpp"
#include "path_memory.hpp"
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
};

}  // namespace tolman::bayesian_attractor
