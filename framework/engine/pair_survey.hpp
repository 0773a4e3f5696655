// SPDX-License-Identifier: BSD-3-Clause
// Checks the rectification of a recording by some of its pairs: the row differences of matched
// corners, and whether the images are exchanged or one image is mirrored.
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

  /// The signed median of the row differences, and the limit within which 90 % of them are; a
  /// warning or an error with the remedy if the pairs are not sound. Empty without pairs.
  std::vector<Finding> findings() const;

 private:
  int pairs_ = 0;
  int brightest_ = 0;         ///< grey level of the left images, see brightest()
  std::vector<double> rows_;  ///< right minus left, px, of all matched corners
  int exchanged_ = 0;         ///< number of them that are further right in the right image
  int mirrored_ = 0;          ///< corners matched in the mirrored right image
  int mirrored_exchanged_ = 0;
};

}  // namespace tolman::imaging
