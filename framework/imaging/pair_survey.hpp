// SPDX-License-Identifier: BSD-3-Clause
// What some pairs of a recording say about their rectification: how far apart the rows of matched
// corners are, and whether sides are exchanged or one image is mirrored.
#pragma once

#include <vector>

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::imaging {

class PairSurvey {
 public:
  /// Frames without two images are not counted.
  void add(const Frame& frame);
  int pairs() const { return pairs_; }

  /// Median of the differences in rows with its sign, and what 90 % of them are within; a warning
  /// or an error with the remedy where the pairs are not sound. Empty for too few matched corners.
  std::vector<Finding> findings() const;

 private:
  int pairs_ = 0;
  std::vector<double> rows_;  ///< right minus left, px, of all matched corners
  int exchanged_ = 0;         ///< of them, found further right in the right image
  int mirrored_ = 0;          ///< corners matched in the mirrored right image
  int mirrored_exchanged_ = 0;
};

}  // namespace tolman::imaging
