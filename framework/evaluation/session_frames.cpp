// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/session_frames.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <optional>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {
namespace {

std::map<std::size_t, Matches> matchesOfSessions(const Matches& matches) {
  std::map<std::size_t, Matches> sessions;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    Matches& session = sessions[matches.truth[i].session];
    session.truth.push_back(matches.truth[i]);
    session.estimate.push_back(matches.estimate[i]);
  }
  return sessions;
}

/// Sum of the squared position errors after the best alignment, m^2; none if there is no alignment.
std::optional<double> squaredErrors(const Matches& matches, Alignment alignment) {
  const Result<Similarity> similarity = align(matches, alignment);
  if (!similarity.isOk()) return std::nullopt;
  const Direction direction = alignment == Alignment::Se2 ? Direction::Horizontal : Direction::All;
  const double rmse = absoluteError(aligned(matches, similarity.value()), direction).rmse;
  return rmse * rmse * static_cast<double>(matches.size());
}

double extentOf(const Trajectory& truth) {
  Eigen::AlignedBox3d box;
  for (const TrajectoryPose& pose : truth) box.extend(pose.T_world_camera.translation());
  return box.diagonal().norm();
}

}  // namespace

std::string sessionFramesHint(const Matches& matches, Alignment alignment) {
  // Eight cuts of KITTI 00, 02, 05 and 06 have factors of 1.0 to 1.2, and 41 with the truth of 05
  // from the first frame of each session. Chosen between, not tuned.
  constexpr double kFactor = 5;
  // The same cuts have at most 0.014, and 0.14. Sessions that are short or straight are fitted
  // exactly on their own, so the factor alone says nothing of them.
  constexpr double kOfExtent = 0.02;
  const std::map<std::size_t, Matches> sessions = matchesOfSessions(matches);
  if (sessions.size() < 2) return "";
  const Alignment compared = alignment == Alignment::None ? Alignment::Se3 : alignment;
  double sum = 0;
  for (const auto& [number, session] : sessions) {
    const std::optional<double> errors = squaredErrors(session, compared);
    if (!errors) return "";  // a session that does not move, with a free scale
    sum += *errors;
  }
  const auto poses = static_cast<double>(matches.size());
  const double alone = std::sqrt(sum / poses);
  const double together = std::sqrt(squaredErrors(matches, compared).value_or(0) / poses);
  if (together <= kFactor * alone || together <= kOfExtent * extentOf(matches.truth)) return "";
  return fmt::format(
      "with an alignment of each session on its own the ATE is {:.3g} m, with one of all sessions "
      "{:.3g} m: either the true poses of the sessions are not in one frame (of the plugins of "
      "Tolman only motion_log with truth_origin: data gives such; the others count from the first "
      "frame of each session), or the map joins the sessions at a wrong place{}. The errors over "
      "all sessions, and the counts of false loops, mean nothing in the first case",
      alone, together, compared == Alignment::Sim3 ? ", or in units of different lengths" : "");
}

}  // namespace tolman::evaluation
