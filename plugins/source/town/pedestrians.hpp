// SPDX-License-Identifier: BSD-3-Clause
// People on the pavements: positions and postures as a function of time.
#pragma once

#include <cstdint>
#include <vector>

#include "pavement.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Postures of a step, left and right leg; one more posture stands.
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
  /// Walks to and fro on one run and waits at both ends; at speed 0 stands at `start`.
  struct Person {
    std::size_t run = 0;
    double start = 0;       ///< m
    double speed = 0;       ///< m/s
    double waits = 0;       ///< s, at each end
    double size = 1;        ///< of an adult
    double run_length = 0;  ///< m
  };

  const StreetPlan* plan_;
  std::vector<PavementRun> runs_;
  std::vector<Person> people_;
};

}  // namespace tolman::town
