// SPDX-License-Identifier: BSD-3-Clause
// Time of day, weather and season by part of the drive, from a line of text:
//
//   pass 2 = night; 300-450 m = dusk rain; pass 3-4 = snow bare exchanged
//
// Entries are separated by semicolons; where several hold, each says what it names and later ones
// win. A pass counts how often the same street has been driven, in either direction.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "light.hpp"
#include "route.hpp"
#include "tolman/status.hpp"

namespace tolman::town {

/// What holds at one frame; what is not said is as the other parameters have it.
struct Condition {
  std::optional<double> hour;
  std::optional<Weather> weather;
  bool is_night = false;   ///< lamps, lit windows and headlights
  bool rains = false;      ///< wet ground and streaks
  bool snow = false;       ///< on what faces upwards
  bool bare = false;       ///< no leaves on trees and bushes
  bool exchanged = false;  ///< other cars are parked

  friend bool operator==(const Condition&, const Condition&) = default;
};

struct ConditionEntry {
  bool is_pass = false;  ///< the range counts passes from 1, else m driven
  double first = 0;
  double last = 0;  ///< inclusive
  std::vector<std::string> words;
};

/// Refuses what is not in the grammar with the entry, what is wrong and what is possible.
Result<std::vector<ConditionEntry>> parseConditions(const std::string& text);

/// m driven at each frame.
std::vector<double> drivenMetres(const CameraRoute& route);

/// How often the street under each frame has been driven, from 1, this time included. Meetings of
/// less than 15 m, as at junctions, do not count.
std::vector<int> passNumbers(const CameraRoute& route);

/// One for each frame of the route.
std::vector<Condition> conditionsOf(const CameraRoute& route,
                                    const std::vector<ConditionEntry>& entries);

}  // namespace tolman::town
