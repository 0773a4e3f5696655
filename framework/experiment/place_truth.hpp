// SPDX-License-Identifier: BSD-3-Clause
// Which images show the same place, by their numbers, a list of pairs, or the true poses; claims
// that a place is passed in the opposite direction; and curves of precision over recall.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
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

/// Image `query` was recognised as the place of the earlier image `place`, passed in the opposite
/// direction.
struct TurnedAnswer {
  std::int64_t query = -1;
  std::int64_t place = -1;
  double score = 0;
  Eigen::Isometry3d T_place_query = Eigen::Isometry3d::Identity();
};

struct OppositePlaces {
  struct Claim {
    std::int64_t query = -1;
    std::int64_t place = -1;
    double score = 0;
    double error_m = 0;  ///< claimed position to the true one
    bool right = false;  ///< within 5 m, and the headings are opposite
  };

  std::int64_t findable = 0;  ///< images that pass a place in the opposite direction alone
  std::int64_t found = 0;     ///< those of `findable` at most 5 m of path after a right claim
  std::vector<Claim> claims;

  std::int64_t right() const;
  /// Median error of the right claims; 0 without any.
  double medianError() const;
};

/// `truth` has a pose for each image; `height_m`: as RevisitRule::height_m.
OppositePlaces judgeOpposite(const evaluation::Trajectory& truth,
                             const std::vector<TurnedAnswer>& answers, double height_m = 0);

struct PlaceCurve {
  std::string name;
  std::vector<evaluation::PrecisionRecall> points;
};

/// The curve in a file with the output of `tolman bench places --json`.
Result<PlaceCurve> placeCurveOf(const std::filesystem::path& file);

/// Curves of a measurement and of earlier ones in one figure, as SVG.
std::string placeCurvesFigure(const std::vector<PlaceCurve>& curves);

}  // namespace tolman::experiment
