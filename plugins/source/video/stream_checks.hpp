// SPDX-License-Identifier: BSD-3-Clause
// Damage of Ogg and Flash files that FFmpeg reads over: it searches for the next page or tag.
#pragma once

#include <string>

#include "container_bytes.hpp"

namespace tolman::video {

/// Follows the pages of an Ogg file (RFC 3533, section 6) and compares their check sums. The first
/// contradiction; empty: none.
std::string defectOfOgg(ContainerBytes& file);

/// Follows the tags of an FLV file. It has no check sums.
std::string defectOfFlv(ContainerBytes& file);

}  // namespace tolman::video
