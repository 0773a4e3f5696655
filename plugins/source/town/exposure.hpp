// SPDX-License-Identifier: BSD-3-Clause
// Exposure time for the present light, and amplification of the signal.
#pragma once

#include "light.hpp"

namespace tolman::town {

struct Exposure {
  double time_ms = 0;
  double amplification = 1;  ///< of signal and noise, if the longest time is too short
};

/// `noon_ms` is the time in the sun of a clear noon; 0 makes exposure independent of the light.
Exposure exposureFor(const Light& light, double noon_ms, double longest_ms);

}  // namespace tolman::town
