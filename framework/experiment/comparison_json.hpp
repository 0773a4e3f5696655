// SPDX-License-Identifier: BSD-3-Clause
// Comparisons and tables as JSON, for programs.
#pragma once

#include <string>

#include "experiment/comparison.hpp"
#include "experiment/text_table.hpp"

namespace tolman::experiment {

/// An object with metric, factors, baseline, notes and a list of levels. Numbers are exact; what
/// cannot be told, such as an interval of too few runs, is null.
std::string jsonOf(const Comparison& comparison);
/// An object with notes and a list of rows: objects of cells by their headings, as text.
std::string jsonOf(const TextTable& table);

}  // namespace tolman::experiment
