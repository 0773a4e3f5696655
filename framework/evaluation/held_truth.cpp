// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/held_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {
namespace {

double distanceBetween(const Trajectory& path, std::size_t from, std::size_t to) {
  return (path[to].T_world_camera.translation() - path[from].T_world_camera.translation()).norm();
}

/// Whether frame `i` has exactly the true pose of the frame before. A gap of tracking or of the
/// truth ends a stretch: how the robot drove there is not known.
bool isRepeated(const Matches& pairs, std::size_t i) {
  return pairs.truth[i].T_world_camera.matrix() == pairs.truth[i - 1].T_world_camera.matrix() &&
         pairs.estimate[i].tracked && pairs.estimate[i - 1].tracked && pairs.inOnePiece(i - 1, i);
}

/// Median distance between consecutive poses, m; 0 for fewer than two.
double usualStep(const Trajectory& path) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < path.size(); ++i) steps.push_back(distanceBetween(path, i - 1, i));
  return steps.empty() ? 0 : statistics(steps).median;
}

/// Whether the true step after pair `last` is as long as the way of the estimate since `first`, and
/// much longer than a step of the estimate, there and elsewhere. Where a robot really stands, and
/// only the estimate drifts, the truth goes on with a step as long as that of the estimate.
bool jumpsAfter(const Matches& pairs, std::size_t first, std::size_t last, double usual) {
  constexpr double kAsLong = 2;   // at most this factor between the two; chosen, not tuned
  constexpr double kSteps = 1.8;  // steps; one over three equal poses is of 3; chosen, not tuned
  const std::size_t next = last + 1;
  if (!pairs.estimate[next].tracked || !pairs.inOnePiece(last, next)) return false;
  const double jump = distanceBetween(pairs.truth, last, next);
  const double way = distanceBetween(pairs.estimate, first, next);
  const double longest = std::max(usual, distanceBetween(pairs.estimate, last, next));
  return jump > kSteps * longest && jump < kAsLong * way && way < kAsLong * jump;
}

}  // namespace

std::string heldHint(const Matches& aligned) {
  constexpr std::size_t kFewest = 3;    // frames of one pose; two may be of one moment
  constexpr double kMoved = 0.5;        // m; chosen, not tuned
  constexpr double kMovedShare = 0.01;  // of the true path, for small rooms; chosen, not tuned
  const double moved = std::min(kMoved, kMovedShare * pathLength(aligned.truth));
  const double usual = usualStep(aligned.estimate);
  for (std::size_t first = 0, i = 1; i < aligned.size(); ++i) {
    if (isRepeated(aligned, i)) continue;
    const std::size_t last = i - 1;
    const double way = distanceBetween(aligned.estimate, first, last);
    if (i - first >= kFewest && way >= moved && jumpsAfter(aligned, first, last, usual)) {
      return fmt::format(
          "the truth stands still from frame {} to {} while the estimate moves {:.3g} m, and then "
          "jumps {:.3g} m: are poses held or missing? All errors are wrong if so",
          aligned.truth[first].frame, aligned.truth[last].frame, way,
          distanceBetween(aligned.truth, last, i));
    }
    first = i;
  }
  return "";
}

}  // namespace tolman::evaluation
