// SPDX-License-Identifier: BSD-3-Clause
// Asks a roscore one question before roscpp does: roscpp waits for an answer without end, and
// crashes or throws on one that is not a roscore's.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "tolman/status.hpp"

namespace tolman::ros1_node {

/// InvalidInput, in words for a person, unless a roscore answers within `limit`. `uri`: for the
/// words; `host` and `port` are its parts.
Status probeMaster(const std::string& uri, const std::string& host, std::uint32_t port,
                   std::chrono::milliseconds limit);

}  // namespace tolman::ros1_node
