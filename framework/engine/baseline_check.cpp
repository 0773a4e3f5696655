// SPDX-License-Identifier: BSD-3-Clause
#include "engine/baseline_check.hpp"

#include <fmt/format.h>

namespace tolman::imaging {

std::string baselineDoubt(const CameraRig& rig) {
  constexpr double kNearest = 0.01;  // m
  constexpr double kWidest = 10;     // m
  if (!rig.isStereo() || (rig.baseline >= kNearest && rig.baseline <= kWidest)) return "";
  return fmt::format(
      "the two cameras are {:.4g} m apart, and usual pairs 0.01 to 10 m; all lengths of the run "
      "are in this unit: if they are not that far apart, correct the baseline (in metres, not mm "
      "or cm) in the calibration or in the source's parameters",
      rig.baseline);
}

}  // namespace tolman::imaging
