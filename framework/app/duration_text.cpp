// SPDX-License-Identifier: BSD-3-Clause
#include "app/duration_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tolman::app {

std::string durationText(double seconds) {
  const double known = std::isfinite(seconds) ? std::clamp(seconds, 0.0, 1e9) : 0.0;
  const long long tenths = std::llround(10 * known);
  if (tenths < 600) return fmt::format("{}.{} s", tenths / 10, tenths % 10);
  const long long whole = std::llround(known);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  const long long minutes = std::llround(known / 60);
  return fmt::format("{}:{:02} h", minutes / 60, minutes % 60);
}

}  // namespace tolman::app
