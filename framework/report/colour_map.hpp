// SPDX-License-Identifier: BSD-3-Clause
// Colour map viridis (S. van der Walt and N. Smith, 2015), interpolated between nine of its
// colours: perceptually uniform, also with colour blindness.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "report/svg.hpp"

namespace tolman::report {

/// "#rrggbb" for a value in [0, 1]; values outside are clamped.
std::string rateColour(double value);

/// 0xaarrggbb, row by row from the top.
using Pixels = Eigen::Matrix<std::uint32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// The colours of rates (right, up): yellow for `most`; NaN is transparent.
Pixels ratePixels(const Eigen::MatrixXd& rates, double most);

/// The colours from 0 to 1 as a bar between two labels, centred at `middle`.
void colourBar(Svg& svg, const Eigen::Vector2d& middle, std::string_view low,
               std::string_view high);

}  // namespace tolman::report
