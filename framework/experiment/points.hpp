// SPDX-License-Identifier: BSD-3-Clause
// The points of a sweep: one run each.
#pragma once

#include <string>
#include <vector>

#include "experiment/sweep_file.hpp"

namespace tolman::experiment {

struct Point {
  std::string name;  ///< "period=75,sequence=00,seed=1"; unique
  std::vector<Factor> factors;
  std::vector<Setting> settings;
  std::shared_ptr<const FrontEnd> front_end;
};

/// The product of all axes without what is excluded, then the included points, each with all
/// sequences and seeds. Exclusions that name no factor or leave out no point are problems.
std::vector<Point> pointsOf(const SweepFile& sweep, config::Problems& problems);

}  // namespace tolman::experiment
