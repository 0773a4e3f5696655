// SPDX-License-Identifier: BSD-3-Clause
// Damage of a Matroska or WebM file (RFC 9559) that FFmpeg reads over: it leaves out whatever it
// cannot read and searches for the next cluster, without an error, and computes no check sums.
#pragma once

#include <string>

#include "container_bytes.hpp"

namespace tolman::video {

/// The first contradiction in the elements of a file, such as "is damaged: its check sum at byte
/// 1234 does not match"; empty: none. Reads pictures only where the file has check sums.
std::string defectOfMatroska(ContainerBytes& file);

}  // namespace tolman::video
