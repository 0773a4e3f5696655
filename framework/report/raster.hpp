// SPDX-License-Identifier: BSD-3-Clause
// A figure as pixels, for slides and papers that take no SVG.
#pragma once

#include <string>

#include "tolman/status.hpp"

namespace tolman::report {

/// The bytes of a PNG file, `zoom` pixels a unit of the picture. Failed for what is no SVG, or too
/// large.
Result<std::string> pngOf(const std::string& svg, double zoom = 2);

}  // namespace tolman::report
