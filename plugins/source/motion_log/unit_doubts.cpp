// SPDX-License-Identifier: BSD-3-Clause
#include "unit_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace tolman::motion_log {
namespace {

// The default limits of `checks`. In degrees every turn of more than 0.17 rad/s exceeds the first,
// in mm every way of more than 0.1 m/s the second.
constexpr double kFastestTurn = 10;  // rad/s
constexpr double kFastest = 100;     // m/s
// The same turn does not last: in drives in degrees 5 to 30 % of the steps are of curves.
constexpr double kShareOfTurns = 0.01;
constexpr double kShareOfWays = 0.5;

// Of candidates. Those of KITTI lead at most 4 m away. The share was chosen on drive 06: half of
// its lengths exceed 100 m in cm, all in mm.
constexpr double kFarthestAlike = 100;  // m
constexpr double kDriftOfWay = 10;      // m
constexpr double kShareOfCandidates = 0.25;
// In radians both differences from the odometry are its drift, in degrees the second is: the ratio
// is 0.93 and 19 on drive 06, for which this was chosen; on 00, 02 and 05 at most 1.05 and at least
// 2.5. Fewer candidates may all be wrong ones.
constexpr double kRatioOfTurns = 2;
constexpr std::size_t kFewestTurns = 5;

std::string ofSteps(std::size_t many, std::size_t all) {
  return std::to_string(many) + " of " + std::to_string(all) + " steps";
}

/// The way along the poses up to each of them, m.
std::vector<double> waysTo(const std::vector<PlanarPose>& poses) {
  std::vector<double> ways(poses.size());
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const PlanarPose step = between(poses[i - 1], poses[i]);
    ways[i] = ways[i - 1] + std::hypot(step.x, step.y);
  }
  return ways;
}

double turnOf(double radians) { return std::abs(std::remainder(radians, 2 * std::numbers::pi)); }

/// Candidates without length say nothing of its unit: some detectors give none.
std::vector<std::string> lengthDoubts(const std::vector<Edge>& candidates,
                                      const std::vector<PlanarPose>& poses) {
  const std::vector<double> ways = waysTo(poses);
  std::size_t all = 0;
  std::size_t far = 0;
  for (const Edge& edge : candidates) {
    const double length = std::hypot(edge.motion.x, edge.motion.y);
    const double way =
        ways[static_cast<std::size_t>(edge.from)] - ways[static_cast<std::size_t>(edge.to)];
    all += length > 0 ? 1 : 0;
    far += length > std::min(kFarthestAlike, way + kDriftOfWay) ? 1 : 0;
  }
  if (static_cast<double>(far) <= kShareOfCandidates * static_cast<double>(all)) return {};
  return {std::to_string(far) + " of " + std::to_string(all) +
          " loop candidates with a length lead further than 100 m or than the way by odometry "
          "between their frames; are their lengths in mm or cm? They must be in metres"};
}

std::vector<std::string> angleDoubts(const std::vector<Edge>& candidates,
                                     const std::vector<PlanarPose>& poses) {
  constexpr double kDegree = std::numbers::pi / 180;
  std::size_t all = 0;
  double as_radians = 0;
  double as_degrees = 0;
  for (const Edge& edge : candidates) {
    if (edge.motion.theta == 0) continue;
    const double driven = between(poses[static_cast<std::size_t>(edge.from)],
                                  poses[static_cast<std::size_t>(edge.to)])
                              .theta;
    ++all;
    as_radians += turnOf(edge.motion.theta - driven);
    as_degrees += turnOf(edge.motion.theta * kDegree - driven);
  }
  if (all < kFewestTurns || as_radians <= kRatioOfTurns * as_degrees) return {};
  return {"the angles of " + std::to_string(all) +
          " loop candidates agree with the odometry far better as degrees; are they in degrees? "
          "They must be in radians"};
}

}  // namespace

std::vector<std::string> candidateDoubts(const std::vector<Edge>& candidates,
                                         const std::vector<PlanarPose>& poses) {
  std::vector<std::string> texts = angleDoubts(candidates, poses);
  for (std::string& text : lengthDoubts(candidates, poses)) texts.push_back(std::move(text));
  return texts;
}

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
