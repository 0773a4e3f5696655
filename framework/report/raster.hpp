// SPDX-License-Identifier: BSD-3-Clause
// Renders a figure to PNG, with librsvg.
#pragma once

#include <string>

#include "tolman/status.hpp"

namespace tolman::report {

/// The bytes of a PNG file with `zoom` pixels per unit of the SVG. Failed for text that is no SVG,
/// and for pictures that are too large.
Result<std::string> pngOf(const std::string& svg, double zoom = 2);

}  // namespace tolman::report
