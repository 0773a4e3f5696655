// SPDX-License-Identifier: BSD-3-Clause
// Curves of precision over recall in one figure: of a measurement, and of earlier ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/precision_recall.hpp"
#include "tolman/status.hpp"

namespace tolman::bench {

struct PlaceCurve {
  std::string name;
  std::vector<evaluation::PrecisionRecall> points;
};

/// The curve in a file with the output of `tolman bench places --json`.
Result<PlaceCurve> placeCurveOf(const std::filesystem::path& file);

/// As SVG, in the style of the report.
std::string placeCurvesFigure(const std::vector<PlaceCurve>& curves);

}  // namespace tolman::bench
