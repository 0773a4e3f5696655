// SPDX-License-Identifier: BSD-3-Clause
// The map as bytes. What is read is believed only as far as it is sound: indices within bounds,
// numbers finite, rotations rotations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <tolman/status.hpp>

#include "experience_chain.hpp"
#include "motion_log.hpp"

namespace tolman::experience_map {

struct MapState {
  MotionLog motions;
  ExperienceChain chain;
  std::int64_t version = 0;
  std::size_t next_correction = 0;
};

Status saveMap(const MapState& map, std::ostream& stream);

/// Fills a fresh map, and leaves it alone when the bytes are not sound.
Status loadMap(std::istream& stream, MapState& map);

}  // namespace tolman::experience_map
