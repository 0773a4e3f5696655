// SPDX-License-Identifier: BSD-3-Clause
// The points of a sweep: one run each.
#pragma once

#include <string>
#include <vector>

#include "experiment/sweep_file.hpp"

namespace tolman::experiment {

struct SweepPoint {
  std::string name;  ///< "period=75,sequence=00,seed=1"; unique
  std::vector<Factor> factors;
  std::vector<Setting> settings;
  std::shared_ptr<const FrontEnd> front_end;
};

/// The product of all axes without the excluded points, then the included points, each with all
/// sequences and seeds. Problems are: exclusions that name no factor or exclude no point, and a
/// factor or a key that two axes vary.
std::vector<SweepPoint> pointsOf(const SweepFile& sweep, config::Problems& problems);

}  // namespace tolman::experiment
