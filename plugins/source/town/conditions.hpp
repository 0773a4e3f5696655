// SPDX-License-Identifier: BSD-3-Clause
// Time of day, weather and season, from a line of text:
//
//   overcast
//   pass 2-9 = night; pass 3-4 = 18:00 snow bare exchanged
//
// Entries are separated by semicolons. Where several apply, each sets what it names, and later ones
// take precedence. A pass counts how often the same street has been driven, in either direction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "light.hpp"
#include "route.hpp"
#include "tolman/status.hpp"

namespace tolman::town {

/// Conditions at one frame.
struct Condition {
  double hour = 10.5;  ///< of a summer's day
  Weather weather = Weather::Clear;
  double haze = 0.0008;    ///< extinction, 1/m; halves the contrast at 870 m
  bool is_night = false;   ///< lamps, lit windows and headlights
  bool snow = false;       ///< on surfaces that face upwards
  bool bare = false;       ///< no leaves on trees and bushes
  bool exchanged = false;  ///< other cars are parked

  friend bool operator==(const Condition&, const Condition&) = default;
};

/// For each frame the number of passes over its street so far, with the present one. Meetings
/// shorter than 15 m, as at junctions, are ignored.
std::vector<int> passNumbers(const CameraRoute& route);

/// Light and season at each frame of the drive.
class Conditions {
 public:
  /// A failure names the entry, the error and the possible values.
  static Result<Conditions> make(const std::string& text, const CameraRoute& route,
                                 std::uint32_t seed);

  /// Changes of light are spread over 20 m of driving, so that odometry does not lose track.
  Light lightAt(std::size_t frame) const;
  const Condition& at(std::size_t frame) const { return conditions_[frame]; }
  /// Whether it is so anywhere on the drive.
  template <class Is>
  bool any(const Is& is) const {
    for (const Condition& condition : conditions_) {
      if (is(condition)) return true;
    }
    return false;
  }
  /// Of entries that hold nowhere.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::vector<Condition> conditions_;  ///< of each frame
  std::vector<Light> lights_;          ///< of each frame, before changes are spread
  std::vector<double> driven_;         ///< m, until each frame
  std::vector<std::string> warnings_;
};

}  // namespace tolman::town
