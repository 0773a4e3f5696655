// SPDX-License-Identifier: BSD-3-Clause
// One connection to the viewer, without a network: the bytes of a client, then the end.
#pragma once

#include <string_view>

namespace tolman::fuzz {

/// Sends `bytes` to a viewer with a short run, and closes. The
/// connection must have ended after that.
void connectAndSend(std::string_view bytes);

}  // namespace tolman::fuzz
