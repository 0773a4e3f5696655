// SPDX-License-Identifier: BSD-3-Clause
// Error codes of FFmpeg's libraries as text.
#pragma once

#include <string>

namespace tolman::video {

/// "Invalid data found when processing input"
std::string libavError(int code);

}  // namespace tolman::video
