// SPDX-License-Identifier: BSD-3-Clause
// Figures of a comparison, as wide as a column of a paper (88.9
// mm), in colours that colour-blind readers can distinguish (Okabe and Ito 2008).
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/comparison.hpp"
#include "report/axes.hpp"

namespace tolman::experiment {

enum class FigureKind : std::uint8_t {
  Auto,     ///< Line where the first factor is a number, else Box
  Line,     ///< mean over the first factor with its interval as a band, a line for each of the rest
  Box,      ///< quartiles, whiskers to all values, and a dot for each run
  Success,  ///< share of the runs whose metric is at most a limit, over that limit
  Distance,  ///< position error over the driven path: mean of the runs, quartiles as a band
  Maps,      ///< the true path, and the map of the median run of each level
};
inline constexpr std::array<std::string_view, 6> kFigureKindNames = {"auto",    "line",     "box",
                                                                     "success", "distance", "maps"};
constexpr std::span<const std::string_view> enumNames(FigureKind) { return kFigureKindNames; }

/// SVG. Distance and Maps open the records of the runs, and need a single true path.
/// InvalidParameter for several true paths, and for Line if the labels are not numbers;
/// InvalidInput for records that cannot be read.
Result<std::string> comparisonFigure(const Comparison& comparison,
                                     FigureKind kind = FigureKind::Auto);

}  // namespace tolman::experiment
