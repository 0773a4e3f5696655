// SPDX-License-Identifier: BSD-3-Clause
// Which experiences hang together. A session that no loop has joined with another, or a robot that
// was carried away, leaves a map in parts; poses of different parts say nothing of each other.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::record {

struct GraphParts {
  std::vector<std::int64_t> of_experience;  ///< part of each experience, dense from 0 by least id
  std::int64_t count = 0;
};

/// By loops that the optimiser has not given up, and by what was driven.
GraphParts partsOf(const MapGraph& graph);

}  // namespace tolman::record
