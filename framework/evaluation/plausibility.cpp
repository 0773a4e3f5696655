// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/plausibility.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "evaluation/errors.hpp"
#include "evaluation/hypotheses.hpp"
#include "evaluation/step_series.hpp"
#include "evaluation/vertical.hpp"

namespace tolman::evaluation {
namespace {

/// A trajectory that never moves: no alignment, drift or scale follows from it.
std::string stillText(const Matches& matches) {
  constexpr double kWanders = 1e-3;  // m; a standing camera's truth from any sensor wanders further
  const auto moves = [&](const Trajectory& path, double least) {
    return std::ranges::any_of(path, [&](const TrajectoryPose& pose) {
      return (pose.T_world_camera.translation() - path.front().T_world_camera.translation())
                 .norm() > least;
    });
  };
  if (matches.size() < 2) return "";
  if (!moves(matches.truth, kWanders)) {
    return "the truth stands still: the figures say nothing about how well the path was followed; "
           "is this the right file, and are its columns right?";
  }
  return moves(matches.estimate, 1e-6 * pathLength(matches.truth)) ? ""
                                                                   : "the estimate does not move";
}

std::string percent(const Misfit& misfit) {
  return fmt::format("{:.3g} % of the motion, {:.3g} % of the turns", 100 * misfit.translation,
                     100 * misfit.rotation);
}

std::string misreadingText(const std::vector<Hypothesis>& hypotheses) {
  if (hypotheses.empty()) return "";
  std::vector<std::string> readings;
  for (const Hypothesis& each : hypotheses) {
    readings.push_back(fmt::format("if {} ({})", each.text, percent(each.after)));
  }
  return fmt::format(
      "as they are read, truth and estimate contradict each other ({}), but they agree {}. Errors "
      "are wrong until this is mended",
      percent(hypotheses.front().before), fmt::join(readings, ", or "));
}

/// Positions of both in millimetres, say: each fits the other.
std::string speedText(const Matches& matches) {
  constexpr double kFastest = 1000;  // m/s; no aircraft with a camera is faster
  const Trajectory& timed = hasStamps(matches.truth) ? matches.truth : matches.estimate;
  const std::vector<double> lengths = stepLengths(matches.truth);
  std::vector<double> speeds;
  for (std::size_t i = 1; i < timed.size(); ++i) {
    const double seconds = 1e-9 * static_cast<double>(timed[i].stamp_ns - timed[i - 1].stamp_ns);
    if (seconds > 0) speeds.push_back(lengths[i - 1] / seconds);
  }
  const double median = statistics(speeds).median;
  if (median <= kFastest) return "";
  return fmt::format(
      "by the stamps the true path is driven at {:.3g} m/s (median), faster than any vehicle: are "
      "its positions in metres, and the stamps in seconds?",
      median);
}

/// Sessions of which each fits its truth, while motions from one to another do not.
std::string sessionText(const Matches& matches, bool free_scale) {
  constexpr std::size_t kParts = 10;
  constexpr double kApart = 0.25, kAlone = 0.2;
  std::vector<std::size_t> begins = {0};
  for (std::size_t i = 1; i < matches.size(); ++i) {
    if (matches.truth[i].session != matches.truth[i - 1].session) begins.push_back(i);
  }
  if (begins.size() < 2) return "";
  begins.push_back(matches.size());
  std::vector<Stretch> within, across;
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto at = [&](std::size_t session, std::size_t of) {
      return begins[session] + of * (begins[session + 1] - begins[session] - 1) / kParts;
    };
    for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
      within.push_back(stretchBetween(matches, at(k, part / 2), at(k, part / 2 + kParts / 2)));
      if (k > 0) across.push_back(stretchBetween(matches, at(0, part), at(k, part)));
    }
  }
  const double alone = misfitOf(within, free_scale).translation;
  const double together = misfitOf(across, free_scale).translation;
  if (together < kApart || alone > kAlone * together) return "";
  return fmt::format(
      "within the sessions true and estimated motions differ by {:.2g} %, from one session to "
      "another by {:.2g} %: either the true poses of the sessions are not in one frame (of the "
      "plugins of Tolman only motion_log with truth_origin: data gives such; the others count from "
      "the first frame of each session), or the map joins the sessions at a wrong place. In the "
      "first case errors over all sessions, and counts of false loops, mean nothing",
      100 * alone, 100 * together);
}

}  // namespace

std::vector<std::string> doubts(const Trajectory& truth, const Trajectory& estimate,
                                Alignment alignment, std::int64_t max_difference_ns) {
  const Result<Matches> found = associate(truth, estimate, max_difference_ns);
  if (!found.isOk()) return {};
  const Matches& matches = found.value();
  if (std::string still = stillText(matches); !still.empty()) return {still};
  const bool free_scale = alignment == Alignment::Sim3;
  std::vector<std::string> texts = {
      misreadingText(misreadings(truth, matches, free_scale, max_difference_ns >= 0))};
  std::ranges::move(breaksOf(matches), std::back_inserter(texts));
  texts.push_back(sessionText(matches, free_scale));
  texts.push_back(speedText(matches));
  if (alignment == Alignment::Se2) {
    if (const std::string up = upAxisProblem(matches.truth); !up.empty()) {
      texts.push_back(up + ", or use se3; se2 leaves y out");
    }
  }
  std::erase(texts, "");
  return texts;
}

std::string doubtText(const std::vector<std::string>& doubts) {
  return fmt::format("{}", fmt::join(doubts, "; and "));
}

}  // namespace tolman::evaluation
