// SPDX-License-Identifier: BSD-3-Clause
// The difference matrix and the search for lines of constant speed in it.
//
// One column of the difference matrix: the differences of an image from every stored view,
// normalised by the differences of neighbouring views (local contrast enhancement).
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace tolman::seqslam {

/// For each difference: d minus the mean, divided by the standard deviation, of the differences at
/// most `window` / 2 views away; 0 if these are all equal. Never below -sqrt(window).
std::vector<float> enhancedContrast(std::span<const float> differences, int window);

// The search for a sequence: lines of constant speed through the last columns of the difference
// matrix, each ending at a stored view in the newest column.

/// Speeds as published, their step chosen.
struct LineSettings {
  int images = 10;       ///< length of a line
  double slowest = 0.8;  ///< stored views for each image
  double fastest = 1.2;  ///< at least slowest
  double speed_step = 0.1;
  int same_place = 5;  ///< views at most so far from the best one are not rivals
};

struct BestLine {
  std::int64_t end = -1;  ///< the stored view at the end of the line
  double score = 0;       ///< mean of the column's values along the line; smaller is more alike
  double rival = 0;       ///< the least score of the views farther away than `same_place`
};

class LineSearch {
 public:
  explicit LineSearch(const LineSettings& settings);

  /// Columns in the order of their images; older ones may be shorter. Only lines that end at one of
  /// the first `candidates` views are considered. Empty with fewer columns than the length of a
  /// line, and without a rival.
  std::optional<BestLine> best(const std::deque<std::vector<float>>& columns,
                               std::int64_t candidates) const;

 private:
  double scoreOf(const std::deque<std::vector<float>>& columns, std::int64_t end) const;

  LineSettings settings_;
  /// For each speed and image, the newest first: how many views before the end the line is.
  std::vector<std::vector<std::int64_t>> lines_;
};

}  // namespace tolman::seqslam
