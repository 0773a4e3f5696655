// SPDX-License-Identifier: BSD-3-Clause
// Durations as people read them.
#pragma once

#include <string>

namespace tolman::app {

/// "3.7 s", from a minute on "1:04 min", from an hour on "1:02 h".
std::string durationText(double seconds);

}  // namespace tolman::app
