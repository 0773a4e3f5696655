// SPDX-License-Identifier: BSD-3-Clause
#include "differences.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tolman::seqslam {

std::vector<float> enhancedContrast(std::span<const float> differences, int window) {
  const auto size = static_cast<std::int64_t>(differences.size());
  std::vector<float> enhanced;
  enhanced.reserve(differences.size());
  for (std::int64_t i = 0; i < size; ++i) {
    const std::int64_t first = std::max<std::int64_t>(0, i - window / 2);
    const std::int64_t end = std::min(size, i + window / 2 + 1);
    const auto around =
        differences.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
    double mean = 0;
    for (const float value : around) mean += value / static_cast<double>(around.size());
    double variance = 0;
    for (const float value : around) {
      variance += (value - mean) * (value - mean) / static_cast<double>(around.size());
    }
    constexpr double kAlike = 1e-12;  // variance of equal differences, up to rounding; avoids 0 / 0
    const double away = differences[static_cast<std::size_t>(i)] - mean;
    enhanced.push_back(variance > kAlike ? static_cast<float>(away / std::sqrt(variance)) : 0);
  }
  return enhanced;
}

}  // namespace tolman::seqslam
