// SPDX-License-Identifier: BSD-3-Clause
// The fragments of an MP4 file (ISO/IEC 14496-12, section 8.8): each a box `moof` with the number,
// sizes and times of some pictures, and a box `mdat` with their data.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "mp4_boxes.hpp"

namespace tolman::video {

/// Size in bytes of pictures without a size of their own, by the number of their track.
using DefaultSizes = std::map<std::uint64_t, std::uint64_t>;

/// The tracks of the header (box `moov`).
DefaultSizes tracksOf(ContainerBytes& file, const Box& movie);

/// What contradicts itself in the boxes of the whole file; empty: nothing.
std::string defectOfFragments(ContainerBytes& file, const DefaultSizes& tracks);

}  // namespace tolman::video
