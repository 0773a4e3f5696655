// SPDX-License-Identifier: BSD-3-Clause
// One column of the difference matrix: how an image differs from every stored view, each difference
// measured against those of the views stored just before and after it.
#pragma once

#include <span>
#include <vector>

namespace tolman::seqslam {

/// Each difference, less the mean of those at most `window` / 2 places away, in their standard
/// deviations; 0 where they are all alike. Never below -sqrt(window).
std::vector<float> enhancedContrast(std::span<const float> differences, int window);

}  // namespace tolman::seqslam
