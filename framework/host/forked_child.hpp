// SPDX-License-Identifier: BSD-3-Clause
// A child that a plugin forks, and that comes back from the call instead of ending.
#pragma once

#include <sys/types.h>

#include <string_view>

namespace tolman::host {

/// Ends this process at once, with a message on stderr, if it is not `caller`, which began the
/// call: a second host would go on with the same record, and hold its lock when the first has
/// ended. `call` names the call in the message.
void endForkedChild(::pid_t caller, std::string_view call) noexcept;

}  // namespace tolman::host
