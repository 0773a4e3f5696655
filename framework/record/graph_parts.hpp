// SPDX-License-Identifier: BSD-3-Clause
// The connected components of an experience graph. A map has several when no loop joins a session
// with the earlier ones, or when tracking restarted at an unknown pose. The relative pose of two
// components is unknown.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::record {

struct GraphParts {
  std::vector<std::int64_t> of_experience;  ///< component of each experience; the first one is 0
  std::int64_t count = 0;
};

/// The components that all links form that the map has not rejected.
GraphParts partsOf(const MapGraph& graph);

}  // namespace tolman::record
