// SPDX-License-Identifier: BSD-3-Clause
// All that decides the future of the cells, written to and read from a stream.
#pragma once

#include <iosfwd>

#include "experience_log.hpp"
#include "parameters.hpp"
#include "path_memory.hpp"
#include "spatial_cells.hpp"
#include "tolman/status.hpp"
#include "view_links.hpp"

namespace tolman::bayesian_attractor {

Status saveState(const AttractorParameters& parameters, const SpatialCells& cells,
                 const ViewLinks& links, const ExperienceLog& log, const PathMemory& path,
                 std::ostream& stream);

/// Overwrites cells, links, log and path, which hold rubbish after a failure.
Status loadState(const AttractorParameters& parameters, std::istream& stream, SpatialCells& cells,
                 ViewLinks& links, ExperienceLog& log, PathMemory& path);

}  // namespace tolman::bayesian_attractor
