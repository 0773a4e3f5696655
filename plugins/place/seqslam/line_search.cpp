// SPDX-License-Identifier: BSD-3-Clause
#include "line_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tolman::seqslam {
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
