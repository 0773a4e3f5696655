// SPDX-License-Identifier: BSD-3-Clause
// Scores the recorded cells of a run: what rings and grid modules say against the truth, and how
// their units fire. Any plugin that describes its arrays (ArrayDescriptions) is scored.
#pragma once

#include <cstdint>
#include <optional>

#include "evaluation/cell_figures.hpp"
#include "record/run_reader.hpp"
#include "report/run_data.hpp"

namespace tolman::run {

/// Reads the activity once, frame by frame, and keeps bounded samples of it. None for a run without
/// described activity. `data` is of the same run.
Result<std::optional<evaluation::CellFigures>> scoreCells(const record::RunReader& reader,
                                                          const report::RunData& data,
                                                          std::uint64_t seed);

}  // namespace tolman::run
