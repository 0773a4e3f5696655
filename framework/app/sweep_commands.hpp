// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/program.hpp"

namespace tolman::app {

/// Commands on the folder of a sweep, below `sweep`: status, collect, archive and point.
void addSweepCommands(CLI::App& sweep, Invocation& invocation);

}  // namespace tolman::app
