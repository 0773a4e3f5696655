// SPDX-License-Identifier: BSD-3-Clause
#include "unit_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tolman::motion_log {
namespace {

// The default limits of `checks`. In degrees every turn of more than 0.17 rad/s exceeds the first,
// in mm every way of more than 0.1 m/s the second.
constexpr double kFastestTurn = 10;  // rad/s
constexpr double kFastest = 100;     // m/s
// The same turn does not last: in drives in degrees 5 to 30 % of the steps are of curves.
constexpr double kShareOfTurns = 0.01;
constexpr double kShareOfWays = 0.5;

std::string ofSteps(std::size_t many, std::size_t all) {
  return std::to_string(many) + " of " + std::to_string(all) + " steps";
}

}  // namespace

std::vector<std::string> unitDoubts(const std::vector<PlanarPose>& poses, double rate) {
  const std::size_t steps = poses.empty() ? 0 : poses.size() - 1;
  std::size_t turns = 0;
  std::size_t ways = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const PlanarPose step = between(poses[i - 1], poses[i]);
    if (std::abs(step.theta) * rate > kFastestTurn) ++turns;
    if (std::hypot(step.x, step.y) * rate > kFastest) ++ways;
  }
  const auto exceed = [&](std::size_t many, double share) {
    return static_cast<double>(many) > share * static_cast<double>(steps);
  };
  std::vector<std::string> texts;
  if (exceed(turns, kShareOfTurns)) {
    texts.push_back(ofSteps(turns, steps) +
                    " turn faster than 10 rad/s; are its angles in degrees? They must be in "
                    "radians; or is `rate` too high?");
  }
  if (exceed(ways, kShareOfWays)) {
    texts.push_back(
        ofSteps(ways, steps) +
        " are faster than 100 m/s; are its lengths in mm or cm? They must be in metres; "
        "or is `rate` too high?");
  }
  return texts;
}

}  // namespace tolman::motion_log
