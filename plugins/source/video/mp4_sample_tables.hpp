// SPDX-License-Identifier: BSD-3-Clause
// The tables of samples of an MP4 or MOV file (ISO/IEC 14496-12, section 8.6 to 8.7): sizes (stsz),
// places (stsc with stco or co64) and durations (stts) of the same pictures.
#pragma once

#include <string>

#include "mp4_boxes.hpp"

namespace tolman::video {

/// What contradicts itself in the tables of one track (box `trak`); empty: nothing.
std::string defectOfSampleTables(ContainerBytes& file, const Box& track);

}  // namespace tolman::video
