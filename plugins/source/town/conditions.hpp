// SPDX-License-Identifier: BSD-3-Clause
// Time of day, weather and season by part of the drive, from a line of text:
//
//   pass 2 = night; 300-450 m = dusk rain; pass 3-4 = snow bare exchanged
//
// Entries are separated by semicolons. Where several apply, each sets what it names, and later ones
// take precedence. A pass counts how often the same street has been driven, in either direction.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "light.hpp"
#include "route.hpp"
#include "tolman/status.hpp"

namespace tolman::town {

/// Conditions at one frame; those that are not set are given by the other parameters.
struct Condition {
  std::optional<double> hour;
  std::optional<Weather> weather;
  bool is_night = false;   ///< lamps, lit windows and headlights
  bool rains = false;      ///< wet ground and streaks
  bool snow = false;       ///< on surfaces that face upwards
  bool bare = false;       ///< no leaves on trees and bushes
  bool exchanged = false;  ///< other cars are parked

  friend bool operator==(const Condition&, const Condition&) = default;
};

struct ConditionEntry {
  std::string text;      ///< as it was given
  bool is_pass = false;  ///< the range is in passes, from 1; otherwise in m driven
  double first = 0;
  double last = 0;  ///< inclusive
  std::vector<std::string> words;
};

/// A failure names the entry, the error and the possible values.
Result<std::vector<ConditionEntry>> parseConditions(const std::string& text);

/// m driven at each frame.
std::vector<double> drivenMetres(const CameraRoute& route);

/// For each frame the number of passes over its street so far, with the present one. Meetings
/// shorter than 15 m, as at junctions, are ignored.
std::vector<int> passNumbers(const CameraRoute& route);

/// Conditions of each frame of the route; entries that hold at no frame become warnings.
std::vector<Condition> conditionsOf(const CameraRoute& route,
                                    const std::vector<ConditionEntry>& entries,
                                    std::vector<std::string>& warnings);

}  // namespace tolman::town
