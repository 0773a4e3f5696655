// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/step_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {
namespace {

// Chosen on the reference runs on KITTI, the town, a lecture hall and TUM, none of which may alarm.
constexpr double kOutlier = 6;        // robust standard deviations
constexpr double kLeastSpread = 0.2;  // of log_ratio: honest estimates without noise vary, too
constexpr double kLeastTurn = 0.5 * std::numbers::pi / 180;
constexpr double kTimes = 4;     // of its neighbours, if a step stands alone
constexpr double kStill = 0.1;   // of the other's motion
constexpr double kMoves = 0.25;  // of the usual true motion

double length(const Eigen::Isometry3d& motion) { return motion.translation().norm(); }
double angle(const Eigen::Isometry3d& motion) { return Eigen::AngleAxisd(motion.linear()).angle(); }
double median(std::vector<double> values) { return statistics(std::move(values)).median; }

/// Distances from the median in standard deviations, estimated from the median distance.
std::vector<double> robustScores(std::vector<double> values, double least_spread) {
  const double middle = median(values);
  std::vector<double> distances;
  for (double& value : values) distances.push_back(std::fabs(value -= middle));
  const double spread = std::max(1.4826 * median(std::move(distances)), least_spread);
  for (double& value : values) value /= spread;
  return values;
}

/// Median length of the motions that are not zero.
double usualLength(const std::vector<Stretch>& stretches, Eigen::Isometry3d Stretch::*motion) {
  std::vector<double> lengths;
  for (const Stretch& each : stretches) lengths.push_back(length(each.*motion));
  std::erase(lengths, 0);
  return median(std::move(lengths));
}

/// The curve of single steps or of windows, with its outliers.
class Breaks {
 public:
  Breaks(const Matches& matches, std::size_t steps)
      : matches_(matches),
        series_(stepSeries(matches, steps)),
        scores_(robustScores(series_.log_ratio, kLeastSpread)),
        turns_(robustScores(series_.turn, kLeastTurn)),
        scale_(std::exp(median(series_.log_ratio))),
        usual_(usualLength(series_.stretches, &Stretch::truth)) {}

  /// The worst single step that the truth makes alone, or with which the estimate returns to its
  /// first pose. Other jumps of the estimate are errors like any.
  std::string jump() const {
    double worst = kOutlier;
    std::string text;
    for (std::size_t i = 0; i < scores_.size(); ++i) {
      const double score = std::max(std::fabs(scores_[i]), turns_[i]);
      const char* cause = score > worst ? causeOf(i) : nullptr;
      if (cause == nullptr) continue;
      worst = score;
      const auto motion = [](const Eigen::Isometry3d& m) {
        return fmt::format("moves {:.3g} m and turns {:.3g} degrees", length(m),
                           angle(m) * 180 / std::numbers::pi);
      };
      text = fmt::format("from frame {} to {} the truth {} and the estimate {}: {}",
                         frame(at(i).first), frame(at(i).last), motion(at(i).truth),
                         motion(at(i).estimate), cause);
    }
    return text;
  }

  std::vector<std::size_t> restarts() const {
    std::vector<std::size_t> pairs;
    for (std::size_t i = 0; i < scores_.size(); ++i) {
      if (restartsIn(i)) pairs.push_back(at(i).last);
    }
    return pairs;
  }

  /// The longest run of stretches in which the truth (or the estimate) stands while the other
  /// moves.
  std::string standing(bool is_truth, std::size_t fewest) const {
    std::size_t best = 0, end = 0;
    for (std::size_t i = 0, run = 0; i < scores_.size(); ++i) {
      const bool joined = run > 0 && at(i).first == at(i - 1).last;
      run = !stands(i, is_truth) ? 0 : joined ? run + 1 : 1;
      if (run > best) best = run, end = i;
    }
    if (best < fewest) return "";
    const std::size_t first = at(end + 1 - best).first;
    const std::size_t last = at(end).last;
    const double way = distance(is_truth ? matches_.estimate : matches_.truth, first, last);
    const double usual = usual_ * (is_truth ? scale_ : 1) * static_cast<double>(best);
    if (way < kMoves * usual) return "";  // the drift of an estimate at a standstill
    return fmt::format("the {} stands still from frame {} to {} while the {} moves {:.3g} m: {}",
                       is_truth ? "truth" : "estimate", frame(first), frame(last),
                       is_truth ? "estimate" : "truth", way,
                       is_truth ? "are poses held or missing? All errors are wrong if so"
                                : "is odometry lost, or its sensor, without saying so?");
  }

  /// A frame from which on lengths are in another unit, and steady before and after it.
  std::string lengthChange() const {
    constexpr std::ptrdiff_t kFewest = 4;  // stretches before and after
    const double least = std::log(1.5);    // other units differ by more, yards from metres less
    std::vector<double> ratios;
    std::vector<std::size_t> pairs;
    for (std::size_t i = 0; i < scores_.size(); ++i) {
      if (length(at(i).truth) < 0.2 * usual_) continue;
      ratios.push_back(series_.log_ratio[i]);
      pairs.push_back(at(i).first);
    }
    double best = HUGE_VAL;
    std::string text;
    for (auto split = kFewest; split + kFewest <= std::ssize(ratios); ++split) {
      const Statistics before = statistics({ratios.begin(), ratios.begin() + split});
      const Statistics after = statistics({ratios.begin() + split, ratios.end()});
      const auto squares = [](const Statistics& s) {
        return static_cast<double>(s.count) * (s.rmse * s.rmse - s.mean * s.mean);
      };
      const double left = std::max(0.0, squares(before) + squares(after));
      if (left >= best) continue;
      best = left;
      const double deviation = std::sqrt(left / static_cast<double>(ratios.size()));
      const double change = std::fabs(after.mean - before.mean);
      text = change < std::max(least, kOutlier * deviation)
                 ? ""
                 : fmt::format(
                       "the estimate is {:.3g} times as long as the truth until frame {}, "
                       "and {:.3g} times from there on: does the truth change its unit, or "
                       "the estimate its scale? All errors are wrong if so",
                       std::exp(before.mean), frame(pairs[static_cast<std::size_t>(split)]),
                       std::exp(after.mean));
    }
    return text;
  }

 private:
  const Stretch& at(std::size_t i) const { return series_.stretches[i]; }
  std::int64_t frame(std::size_t pair) const { return matches_.truth[pair].frame; }
  static double distance(const Trajectory& path, std::size_t from, std::size_t to) {
    return (path[to].T_world_camera.translation() - path[from].T_world_camera.translation()).norm();
  }

  /// Whether a measure of the motion `i` is far above that of the motions around it.
  template <class Measure>
  bool isAlone(std::size_t i, const Measure& measure) const {
    for (std::size_t k = i < 2 ? 0 : i - 2; k < std::min(i + 3, scores_.size()); ++k) {
      if (k != i && measure(at(i)) < kTimes * measure(at(k))) return false;
    }
    return true;
  }

  const char* causeOf(std::size_t i) const {
    const auto truth = [](const Stretch& s) { return length(s.truth); };
    const auto turn = [](const Stretch& s) { return angle(s.truth); };
    const bool is_jump =
        scores_[i] < -kOutlier && truth(at(i)) > kTimes * usual_ && isAlone(i, truth);
    const bool is_turn = turns_[i] > kOutlier && turn(at(i)) > kTimes * angle(at(i).estimate);
    if (is_jump || (is_turn && isAlone(i, turn))) {
      return "the truth jumps. Is a pose missing or wrong, or are its parts of different drives? "
             "All errors are wrong if so";
    }
    if (!restartsIn(i)) return nullptr;
    return "the estimate starts again at its origin. Score its parts one by one; errors over both "
           "say nothing";
  }

  bool restartsIn(std::size_t i) const {
    const auto estimate = [](const Stretch& s) { return length(s.estimate); };
    const double way = estimate(at(i));
    return scores_[i] > kOutlier && way > kTimes * scale_ * usual_ &&
           distance(matches_.estimate, 0, at(i).last) < kStill * way && isAlone(i, estimate);
  }

  bool stands(std::size_t i, bool is_truth) const {
    if ((is_truth ? scores_[i] : -scores_[i]) < kOutlier) return false;
    const double truth = scale_ * length(at(i).truth), estimate = length(at(i).estimate);
    const double still = is_truth ? truth : estimate, moving = is_truth ? estimate : truth;
    return still < kStill * moving && moving > kMoves * scale_ * usual_;
  }

  const Matches& matches_;
  StepSeries series_;
  std::vector<double> scores_;  ///< of log_ratio
  std::vector<double> turns_;   ///< scores of the turns
  double scale_;                ///< usual ratio of estimated to true lengths
  double usual_;                ///< true length, m
};

}  // namespace

Stretch stretchBetween(const Matches& matches, std::size_t first, std::size_t last) {
  const auto motion = [&](const Trajectory& path) -> Eigen::Isometry3d {
    return path[first].T_world_camera.inverse() * path[last].T_world_camera;
  };
  return {first, last, motion(matches.truth), motion(matches.estimate)};
}

std::vector<Stretch> stretches(const Matches& matches, std::size_t steps) {
  std::vector<Stretch> result;
  std::size_t first = 0;
  for (std::size_t i = 1; i < matches.size(); ++i) {
    const bool is_whole = matches.estimate[i - 1].tracked && matches.estimate[i].tracked &&
                          matches.inOnePiece(i - 1, i);
    if (!is_whole) first = i;
    if (i - first < steps) continue;
    result.push_back(stretchBetween(matches, first, i));
    first = i;
  }
  return result;
}

StepSeries stepSeries(const Matches& matches, std::size_t steps) {
  StepSeries series{stretches(matches, steps), {}, {}, {}};
  const auto slow = [&](Eigen::Isometry3d Stretch::*motion) {
    return kStill * usualLength(series.stretches, motion) + 1e-12;
  };
  const double slow_truth = slow(&Stretch::truth), slow_estimate = slow(&Stretch::estimate);
  for (const Stretch& each : series.stretches) {
    series.frames.push_back(matches.truth[each.last].frame);
    series.log_ratio.push_back(
        std::log((length(each.estimate) + slow_estimate) / (length(each.truth) + slow_truth)));
    series.turn.push_back(angle(each.truth.inverse() * each.estimate));
  }
  return series;
}

std::vector<std::size_t> restartsOf(const Matches& matches) {
  return Breaks(matches, 1).restarts();
}

std::vector<std::string> breaksOf(const Matches& matches) {
  constexpr std::size_t kParts = 40;
  const Breaks windows(matches, 5);
  const Breaks parts(matches, std::max<std::size_t>(5, matches.size() / kParts));
  std::vector<std::string> texts = {Breaks(matches, 1).jump(), windows.standing(true, 2),
                                    windows.standing(false, 20), parts.lengthChange()};
  std::erase(texts, "");
  return texts;
}

}  // namespace tolman::evaluation
