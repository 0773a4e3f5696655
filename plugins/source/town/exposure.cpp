// SPDX-License-Identifier: BSD-3-Clause
#include "exposure.hpp"

#include <algorithm>

namespace tolman::town {

Exposure exposureFor(const Light& light, double noon_ms, double longest_ms) {
  if (noon_ms <= 0) return {};
  const Light noon = makeLight(12, Weather::Clear, 0, 0);
  const double wanted = noon_ms * static_cast<double>(light.dimness * noon.level() / light.level());
  Exposure exposure;
  exposure.time_ms = std::min(wanted, longest_ms);
  exposure.amplification = wanted / exposure.time_ms;
  return exposure;
}

}  // namespace tolman::town
