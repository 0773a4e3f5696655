// SPDX-License-Identifier: BSD-3-Clause
#include "line_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

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

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

LineSearch::LineSearch(const LineSettings& settings) : settings_(settings) {
  constexpr double kRounding = 1e-9;  // so that the fastest speed is tried
  const double range = settings.fastest - settings.slowest;
  const auto steps = static_cast<int>(std::floor(range / settings.speed_step + kRounding));
  for (int s = 0; s <= steps; ++s) {
    const double speed = settings.slowest + s * settings.speed_step;
    std::vector<std::int64_t> line;
    line.reserve(static_cast<std::size_t>(settings.images));
    for (int k = 0; k < settings.images; ++k) line.push_back(std::lround(speed * k));
    lines_.push_back(std::move(line));
  }
}

/// The least mean over all speeds; infinity if no line is within the stored views.
double LineSearch::scoreOf(const std::deque<std::vector<float>>& columns, std::int64_t end) const {
  double least = kNone;
  for (const std::vector<std::int64_t>& line : lines_) {
    double sum = 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const std::vector<float>& column = columns[columns.size() - 1 - k];
      const std::int64_t view = end - line[k];
      const bool exists = view >= 0 && view < static_cast<std::int64_t>(column.size());
      sum += exists ? column[static_cast<std::size_t>(view)] : kNone;
    }
    least = std::min(least, sum / static_cast<double>(line.size()));
  }
  return least;
}

std::optional<BestLine> LineSearch::best(const std::deque<std::vector<float>>& columns,
                                         std::int64_t candidates) const {
  if (columns.size() < static_cast<std::size_t>(settings_.images)) return std::nullopt;
  std::vector<double> scores;
  for (std::int64_t end = 0; end < candidates; ++end) scores.push_back(scoreOf(columns, end));
  const auto least = std::ranges::min_element(scores);  // of equal ones the oldest
  if (least == scores.end()) return std::nullopt;
  BestLine best{least - scores.begin(), *least, kNone};
  for (std::int64_t end = 0; end < candidates; ++end) {
    if (std::abs(end - best.end) <= settings_.same_place) continue;
    best.rival = std::min(best.rival, scores[static_cast<std::size_t>(end)]);
  }
  if (best.rival == kNone) return std::nullopt;
  return best;
}

}  // namespace tolman::seqslam
