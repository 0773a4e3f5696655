// SPDX-License-Identifier: BSD-3-Clause
// Saves and loads the state of the map. Loading checks that indices are within bounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <tolman/status.hpp>

#include "dead_reckoning.hpp"
#include "experience_chain.hpp"

namespace tolman::experience_map {

struct MapCounters {
  std::int64_t version = 0;
  std::size_t next_correction = 0;
};

Status saveMap(const DeadReckoning& motions, const ExperienceChain& chain,
               const MapCounters& counters, std::ostream& stream);

/// Fills `motions` and `chain`, which must be new. On failure nothing changes.
Status loadMap(std::istream& stream, DeadReckoning& motions, ExperienceChain& chain,
               MapCounters& counters);

}  // namespace tolman::experience_map
