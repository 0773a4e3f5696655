// SPDX-License-Identifier: BSD-3-Clause
// Figures and pixels as PNG, figures as PDF, with librsvg and cairo.
#pragma once

#include <string>

#include "report/svg.hpp"
#include "tolman/status.hpp"

namespace tolman::report {

/// The bytes of a PNG file with `zoom` pixels per unit of the SVG. Failed if the text is not SVG,
/// or if the picture is too large. Throws std::bad_alloc if memory is
/// short.
Result<std::string> pngOf(const std::string& svg, double zoom = 2);

/// The bytes of a PDF file of one page, with `points` (1/72 inch) per unit of the SVG: lines and
/// text, no pixels. It has no date, so that the same figure gives the same bytes.
Result<std::string> pdfOf(const std::string& svg, double points = 0.7);

/// The URL of a picture within an SVG: "data:image/png;base64,...".
std::string pngUrl(Pixels pixels);

}  // namespace tolman::report
