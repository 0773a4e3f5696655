// SPDX-License-Identifier: BSD-3-Clause
// Drawing in a process of its own where the address space is limited (`ulimit -v`): the libraries
// of fonts end their process when memory is short, instead of returning an error.
#pragma once

#include <functional>
#include <string>

#include "tolman/status.hpp"

namespace tolman::report {

using Draw = std::function<Result<std::string>()>;

/// What `draw` returns. Throws std::bad_alloc if it ended its process, or if there is none to be
/// had. Call it from a process with no other thread that draws.
Result<std::string> drawnSafely(const Draw& draw);

}  // namespace tolman::report
