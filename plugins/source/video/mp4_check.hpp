// SPDX-License-Identifier: BSD-3-Clause
// Damage of an MP4 or MOV file (ISO/IEC 14496-12) that FFmpeg reads over: of a file in fragments it
// leaves out whatever it cannot read, without an error.
#pragma once

#include "container_bytes.hpp"
#include "container_check.hpp"

namespace tolman::video {

/// The length is that of all fragments, if there is a single track. Compares the tables of samples
/// with each other and, if the file is in fragments, follows them to the end of the file. Reads no
/// pictures.
ContainerCheck checkMp4(ContainerBytes& file);

}  // namespace tolman::video
