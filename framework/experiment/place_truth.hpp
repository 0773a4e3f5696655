// SPDX-License-Identifier: BSD-3-Clause
// Which images show the same place: by their numbers, a list of pairs, or the true poses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "evaluation/loops.hpp"
#include "evaluation/trajectory.hpp"
#include "tolman/status.hpp"

namespace tolman::experiment {

struct PlaceTruth {
  /// Whether image `query` shows the place of `place`.
  std::function<bool(std::int64_t query, std::int64_t place)> isSame;
  /// Whether there is an image that `query` should be recognised in.
  std::function<bool(std::int64_t query)> isFindable;
  std::int64_t last_query = -1;  ///< the highest image number that a list names; -1 without a list
};

/// Image N of the second pass shows the place of the images N +- `tolerance` of the first pass.
PlaceTruth truthByNumber(std::int64_t images_of_first_pass, std::int64_t tolerance);

/// A CSV file with two columns, query and match, and an optional header `query,match`. Errors name
/// file and line. Images at most `near` apart do not make a query findable: claims of them do not
/// count.
Result<PlaceTruth> truthOfPairs(const std::filesystem::path& file, std::int64_t near = 0);

/// Within 5 m, headings less than 45 degrees apart, more than 20 m of path in between.
/// `height_m`: as RevisitRule::height_m. `near`: as above.
PlaceTruth truthOfPoses(const evaluation::Trajectory& truth, double height_m = 0,
                        std::int64_t near = 0);

// Curves of precision over recall in one figure: of a measurement, and of earlier ones.

struct PlaceCurve {
  std::string name;
  std::vector<evaluation::PrecisionRecall> points;
};

/// The curve in a file with the output of `tolman bench places --json`.
Result<PlaceCurve> placeCurveOf(const std::filesystem::path& file);

/// As SVG, in the style of the report.
std::string placeCurvesFigure(const std::vector<PlaceCurve>& curves);

}  // namespace tolman::experiment
