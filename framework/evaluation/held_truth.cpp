// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/held_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "evaluation/truth_steps.hpp"
#include "evaluation/turns.hpp"

namespace tolman::evaluation {
namespace {

/// Whether frame `i` has exactly the true pose of the frame before. A gap of tracking or of the
/// truth ends a stretch: how the robot drove there is not known.
bool isRepeated(const Matches& pairs, std::size_t i) {
  return pairs.truth[i].T_world_camera.matrix() == pairs.truth[i - 1].T_world_camera.matrix() &&
         isTrackedStep(pairs, i);
}

/// Whether the true step to pair `i` is single and long, and the estimate makes none like it.
bool isJump(const Matches& pairs, std::size_t i, double usual) {
  constexpr double kTimes = 4;  // chosen, not tuned: of normal noise one step in 16,000 has 4 rms
  for (std::size_t k = i - 1; k <= i + 1; ++k) {
    if (!pairs.estimate[k].tracked || !pairs.inOnePiece(i - 1, k)) return false;
  }
  if (i < 2 || !pairs.inOnePiece(i - 2, i)) return false;
  const double longest =
      std::max({usual, distanceBetween(pairs.truth, i - 2, i - 1),
                distanceBetween(pairs.truth, i, i + 1), distanceBetween(pairs.estimate, i - 1, i)});
  return distanceBetween(pairs.truth, i - 1, i) > kTimes * longest;
}

/// Whether the true step after pair `last` is as long as the way of the estimate since `first`, and
/// much longer than a step of the estimate, there and elsewhere. Where a robot really stands, and
/// only the estimate drifts, the truth goes on with a step as long as that of the estimate.
bool jumpsAfter(const Matches& pairs, std::size_t first, std::size_t last, double usual) {
  constexpr double kAsLong = 2;   // at most this factor between the two; chosen, not tuned
  constexpr double kSteps = 1.8;  // steps; one over three equal poses is of 3; chosen, not tuned
  const std::size_t next = last + 1;
  if (next == pairs.size()) return false;
  if (!pairs.estimate[next].tracked || !pairs.inOnePiece(last, next)) return false;
  const double jump = distanceBetween(pairs.truth, last, next);
  const double way = distanceBetween(pairs.estimate, first, next);
  const double longest = std::max(usual, distanceBetween(pairs.estimate, last, next));
  return jump > kSteps * longest && jump < kAsLong * way && way < kAsLong * jump;
}

/// A stretch of equal true poses in which the estimate moves as if the robot drove.
std::optional<Standing> heldStretch(const Matches& pairs) {
  constexpr std::size_t kFewest = 3;  // frames of one pose; two may be of one moment
  // Chosen on held parts of KITTI 00 and 01; no alarm on EuRoC, TUM, KITTI 02, 05, 06, 07.
  constexpr double kUsualSpeed = 0.25;  // of the truth's where it moves
  constexpr double kShortest = 5;       // frames without a jump
  const double moved = leastWay(pairs.truth);
  const double usual = statistics(stepLengths(pairs.estimate)).median;
  const double driven = usualStep(pairs.truth);
  for (std::size_t first = 0, i = 1; i <= pairs.size(); ++i) {
    if (i < pairs.size() && isRepeated(pairs, i)) continue;
    Standing held{first, i - 1, distanceBetween(pairs.estimate, first, i - 1)};
    const auto frames = static_cast<double>(i - first);
    first = i;
    if (frames < kFewest || held.way < moved || driven == 0) continue;
    if (jumpsAfter(pairs, held.first, held.last, usual)) {
      held.jump = distanceBetween(pairs.truth, held.last, i);
      return held;
    }
    if (frames >= kShortest && held.way > kUsualSpeed * driven * (frames - 1)) return held;
  }
  return std::nullopt;
}

Matches exchanged(const Matches& pairs) {
  Matches other = pairs;
  std::swap(other.truth, other.estimate);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    other.estimate[i].tracked = pairs.estimate[i].tracked;
  }
  return other;
}

}  // namespace

std::string standingText(const Standing& standing, const Matches& pairs, bool is_truth,
                         const char* still) {
  const std::string jump =
      standing.jump > 0 ? fmt::format(", and then jumps {:.3g} m", standing.jump) : std::string();
  return fmt::format("the {} stands {} from frame {} to {} while the {} moves {:.3g} m{}: {}",
                     is_truth ? "truth" : "estimate", still, pairs.truth[standing.first].frame,
                     pairs.truth[standing.last].frame, is_truth ? "estimate" : "truth",
                     standing.way, jump,
                     is_truth ? "are poses held or missing? All errors are wrong if so"
                              : "is odometry lost, or its sensor, without saying so?");
}

std::string heldHint(const Matches& aligned) {
  if (const auto held = heldStretch(aligned)) return standingText(*held, aligned, true, "still");
  const Matches other = exchanged(aligned);
  if (const auto held = heldStretch(other)) return standingText(*held, other, false, "still");
  return "";
}

std::string jumpHint(const Matches& aligned) {
  const Statistics usual = statistics(stepLengths(aligned.truth));
  const double least = leastWay(aligned.truth);
  for (std::size_t i = 2; i + 1 < aligned.size(); ++i) {
    const double jump = distanceBetween(aligned.truth, i - 1, i);
    if (jump < least || !isJump(aligned, i, usual.rmse)) continue;
    return fmt::format(
        "the truth jumps {:.3g} m from frame {} to {}, where its other steps have {:.3g} m "
        "(median) and the estimate moves {:.3g} m: is a pose missing or wrong? All errors are "
        "wrong "
        "if so",
        jump, aligned.truth[i - 1].frame, aligned.truth[i].frame, usual.median,
        distanceBetween(aligned.estimate, i - 1, i));
  }
  return "";
}

std::string fixedOrientationHint(const Matches& matches) {
  constexpr double kTurned = 90;  // degrees; chosen, not tuned
  const Eigen::Matrix3d first = matches.truth.front().T_world_camera.linear();
  double turned = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (matches.truth[i].T_world_camera.linear() != first) return "";
    if (!matches.estimate[i].tracked || !matches.inOnePiece(0, i)) continue;
    const Eigen::Matrix3d turn = matches.estimate.front().T_world_camera.linear().transpose() *
                                 matches.estimate[i].T_world_camera.linear();
    turned = std::max(turned, Eigen::AngleAxisd(turn).angle() * 180 / std::numbers::pi);
  }
  if (turned < kTurned) return "";
  return fmt::format(
      "all true poses have the same orientation, but the estimate turns by {:.0f} degrees: are the "
      "angles of the truth missing? Drift, rotation errors, and all errors that are measured from "
      "the first pose, are wrong if so",
      turned);
}

}  // namespace tolman::evaluation
