// SPDX-License-Identifier: BSD-3-Clause
// How a run found itself in the map of another one: how long it took, and how often and how far it
// was wrong.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/errors.hpp"
#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

/// Error above which a pose is of another place, m: that of false loops.
inline constexpr double kWrongPlace = 10;

struct LocalisationFigures {
  std::string map;           ///< the run whose map it is
  std::int64_t found = 0;    ///< frames whose place was known
  std::int64_t unknown = 0;  ///< and not known
  std::int64_t lost = 0;     ///< at which odometry was lost
  /// From the first frame of an unknown place until it was found, or until the run ended.
  struct Search {
    std::int64_t first_frame = 0;
    std::int64_t frames = 0;
    double seconds = 0;
    double metres = 0;  ///< driven
    bool found = false;
  };
  std::vector<Search> searches;
  std::string reason;      ///< why there are no errors
  Statistics error_m;      ///< of the pose relative to the experience that it refers to
  std::int64_t wrong = 0;  ///< found frames with an error above kWrongPlace
};

class LocalisationCounter {
 public:
  /// `truth`: with that of the map, in one world frame; it and the experiences must outlive this
  /// object.
  LocalisationCounter(const std::vector<Experience>& experiences, const Trajectory& truth);
  void add(const Motion& motion, const MapUpdate& update);
  LocalisationFigures figures() const;

 private:
  std::optional<double> errorOf(const MapUpdate& update) const;

  const std::vector<Experience>& experiences_;
  std::map<std::int64_t, const Eigen::Isometry3d*> truth_;
  LocalisationFigures figures_;
  std::vector<double> errors_;
};

/// "found in 812 of 1100 frames; ...", for verdicts.
std::string localisationText(const LocalisationFigures& figures);

nlohmann::ordered_json toJson(const LocalisationFigures& figures);

}  // namespace tolman::evaluation
