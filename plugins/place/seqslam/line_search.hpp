// SPDX-License-Identifier: BSD-3-Clause
// The search for a sequence: lines of constant speed through the last columns of the difference
// matrix, each ending at a stored view in the newest column.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace tolman::seqslam {

struct LineSettings {
  int images = 10;       ///< length of a line
  double slowest = 0.8;  ///< stored views for each image
  double fastest = 1.2;
  double speed_step = 0.1;
  int same_place = 5;  ///< views so near to the best are no rivals
};

struct BestLine {
  std::int64_t end = -1;  ///< the view that it ends at
  double score = 0;       ///< mean of the column's values along the line; smaller is more alike
  double rival = 0;       ///< the least score of the views elsewhere
};

class LineSearch {
 public:
  explicit LineSearch(const LineSettings& settings);

  /// Columns in the order of their images; older ones may be shorter. Only lines that end at one of
  /// the first `candidates` views count. Empty with fewer columns than a line is long, and as long
  /// as there is nothing to compare the best with.
  std::optional<BestLine> best(const std::deque<std::vector<float>>& columns,
                               std::int64_t candidates) const;

 private:
  double scoreOf(const std::deque<std::vector<float>>& columns, std::int64_t end) const;

  LineSettings settings_;
  /// For each speed: views between the end and the point at each image, the newest image first.
  std::vector<std::vector<std::int64_t>> lines_;
};

}  // namespace tolman::seqslam
