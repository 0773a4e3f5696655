// SPDX-License-Identifier: BSD-3-Clause
// A comparison as tables: Markdown, LaTeX with booktabs, CSV.
#pragma once

#include <string>

#include "experiment/comparison.hpp"

namespace tolman::experiment {

std::string markdownOf(const Comparison& comparison);
/// Needs \usepackage{booktabs}.
std::string latexOf(const Comparison& comparison);
std::string csvOf(const Comparison& comparison);

}  // namespace tolman::experiment
