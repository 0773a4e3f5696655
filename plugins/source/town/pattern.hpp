// SPDX-License-Identifier: BSD-3-Clause
// Regular patterns averaged over the pixel, for eight points at once: closed-form box filters of
// steps and stripes.
#pragma once

#include "lanes.hpp"

namespace tolman::town {

/// Share of the interval [x - width/2, x + width/2] that is at or above `edge`.
TOLMAN_INLINE Eight filteredStep(Eight edge, Eight x, Eight width) {
  return clamped((x - edge) / larger(width, 1e-5F) + 0.5F, 0, 1);
}
TOLMAN_INLINE Eight filteredStep(float edge, Eight x, Eight width) {
  return filteredStep(eight(edge), x, width);
}
/// Share of the interval around x that is within [low, high].
TOLMAN_INLINE Eight filteredPulse(Eight low, Eight high, Eight x, Eight width) {
  return filteredStep(low, x, width) - filteredStep(high, x, width);
}
TOLMAN_INLINE Eight filteredPulse(float low, float high, Eight x, Eight width) {
  return filteredPulse(eight(low), eight(high), x, width);
}

/// Share of the interval around x covered by stripes [k period, k period + on], k any integer.
TOLMAN_INLINE Eight filteredStripes(float period, float on, Eight x, Eight width) {
  const Eight w = larger(width, 1e-5F);
  // Integral of the stripes from 0 to t.
  const auto covered = [&](Eight t) TOLMAN_INLINE_LAMBDA {
    const Eight cycles = floorOf(t / period);
    return cycles * on + smaller(t - cycles * period, on);
  };
  return (covered(x + w / 2) - covered(x - w / 2)) / w;
}

/// Mean over the interval around x of a function that is value(k) on [k period, (k + 1) period],
/// for intervals up to a period. value() takes eight cells k.
template <class Value>
TOLMAN_INLINE Eight filteredCells(float period, Eight x, Eight width, const Value& value) {
  const Eight k = floorOf(x / period + 0.5F);  // the nearest boundary
  const Eight above = filteredStep(k * period, x, width);
  const EightInts cell = truncated(k);
  return (1 - above) * value(cell - 1) + above * value(cell);
}

}  // namespace tolman::town
