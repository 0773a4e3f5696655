// SPDX-License-Identifier: BSD-3-Clause
// A source plugin for tests: pixels and depth by formulas, on a drive around a circle.
#include "app/painted_source.hpp"

#include "tolman/plugin.hpp"

TOLMAN_PLUGIN(painted, tolman::fixture::Painted, "0.1.0", "Painted by formulas, for tests.");
