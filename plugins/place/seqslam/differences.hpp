// SPDX-License-Identifier: BSD-3-Clause
// One column of the difference matrix: the differences of an image from every stored view,
// normalised by the differences of neighbouring views (local contrast enhancement).
#pragma once

#include <span>
#include <vector>

namespace tolman::seqslam {

/// For each difference: d minus the mean, divided by the standard deviation, of the differences at
/// most `window` / 2 views away; 0 if these are all equal. Never below -sqrt(window).
std::vector<float> enhancedContrast(std::span<const float> differences, int window);

}  // namespace tolman::seqslam
