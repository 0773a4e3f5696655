// SPDX-License-Identifier: BSD-3-Clause
// Splits the driven path into new street sections and second passes over earlier ones.
#pragma once

#include <vector>

#include "street_path.hpp"
#include "street_plan.hpp"

namespace tolman::town {

/// Sections of at least 6 m in the order of driving, with points 1 m apart.
std::vector<StreetSection> findSections(const std::vector<PathPoint>& path);

}  // namespace tolman::town
