// SPDX-License-Identifier: BSD-3-Clause
// People on the pavements: positions and postures as a function of time.
#pragma once

#include <cstdint>
#include <vector>

#include "pavement.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Number of postures of a step with the left and right leg; one more posture is standing.
inline constexpr int kGaitPhases = 6;
inline constexpr int kStanding = kGaitPhases;

class Pedestrians {
 public:
  Pedestrians(std::vector<PavementRun> runs, const StreetPlan& plan, double people_per_km,
              std::uint32_t seed);

  std::size_t size() const { return people_.size(); }
  struct Posture {
    Placement placement;
    int phase = kStanding;  ///< below kGaitPhases of a step
  };
  /// Person `index`, `seconds` after the first pose.
  Posture at(std::size_t index, double seconds) const;

 private:
  /// A person who walks up and down one run and waits at both ends, or stands at `start` (speed 0).
  struct Person {
    std::size_t run = 0;
    double start = 0;       ///< m
    double speed = 0;       ///< m/s
    double waits = 0;       ///< s, at each end
    double size = 1;        ///< relative to an adult
    double run_length = 0;  ///< m
  };

  const StreetPlan* plan_;
  std::vector<PavementRun> runs_;
  std::vector<Person> people_;
};

}  // namespace tolman::town
