// SPDX-License-Identifier: BSD-3-Clause
// Colours for rates: dark for none, bright for most, even steps to the eye, and to those who see
// few colours (anchors of viridis; S. van der Walt and N. Smith, 2015).
#pragma once

#include <string>

namespace tolman::report {

/// "#rrggbb" for a value in [0, 1]; outside values take the nearest end.
std::string rateColour(double value);

}  // namespace tolman::report
