// SPDX-License-Identifier: BSD-3-Clause
// Regular patterns averaged over the pixel: closed-form box filters of steps and stripes.
#pragma once

#include <algorithm>

#include "vec3.hpp"

namespace tolman::town {

/// Share of the interval [x - width/2, x + width/2] that is at or above `edge`.
inline float filteredStep(float edge, float x, float width) {
  return std::clamp((x - edge) / std::max(width, 1e-5F) + 0.5F, 0.0F, 1.0F);
}

/// Share of the interval around x that is within [low, high].
inline float filteredPulse(float low, float high, float x, float width) {
  return filteredStep(low, x, width) - filteredStep(high, x, width);
}

/// Share of the interval around x covered by stripes [k period, k period + on], k any integer.
inline float filteredStripes(float period, float on, float x, float width) {
  const float w = std::max(width, 1e-5F);
  // Integral of the stripes from 0 to t.
  const auto covered = [&](float t) {
    const float cycles = floorOf(t / period);
    return cycles * on + std::min(t - cycles * period, on);
  };
  return (covered(x + w / 2) - covered(x - w / 2)) / w;
}

/// Mean over the interval around x of a function that is value(k) on [k period, (k + 1) period],
/// for intervals up to a period.
template <class Value>
float filteredCells(float period, float x, float width, const Value& value) {
  const float k = floorOf(x / period + 0.5F);  // the nearest boundary
  const float above = filteredStep(k * period, x, width);
  const auto cell = static_cast<int>(k);
  float mean = 0;
  if (above < 1) mean += (1 - above) * value(cell - 1);
  if (above > 0) mean += above * value(cell);
  return mean;
}

}  // namespace tolman::town
