// SPDX-License-Identifier: BSD-3-Clause
// Runs of one recording with different modules: which is best, and which differences the recording
// can decide.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/association.hpp"
#include "experiment/comparison.hpp"

namespace tolman::experiment {

/// The map of a run, transformed into the coordinates of its truth. Throws (base/must.hpp).
evaluation::Matches alignedMap(const std::filesystem::path& run, const std::string& alignment);

enum class Moment : std::uint8_t { Error, Square };
/// Mean position error (m, or m^2) in each of `parts` equal parts of the true path; for a part
/// without frames that of the part before. `planar`: in the plane alone.
std::vector<double> errorsByPart(const evaluation::Matches& matches, std::size_t parts, bool planar,
                                 Moment moment = Moment::Error);

struct Ranked {
  const RunRow* run = nullptr;
  double rmse_m = 0;     ///< position error of the map after alignment
  Interval interval{};   ///< 95 %, of rmse_m
  bool as_good = false;  ///< the first, or no worse as far as this recording can decide
};

/// The runs with an error, best first. Intervals are bootstrapped over equal parts of the true
/// path, because errors of neighbouring frames are alike. A run is as good as the best if the
/// interval of their difference in squared error, part by part, includes zero. `rows` must outlive
/// the result. InvalidInput for records that cannot be read.
Result<std::vector<Ranked>> rankedRuns(const std::vector<RunRow>& rows);

/// The ranked runs, then those without an error: factors, error, loop links.
Table tableOf(const std::vector<Ranked>& ranked, const std::vector<RunRow>& rows);

}  // namespace tolman::experiment
