// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/step_series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text_file.hpp"
#include "evaluation/errors.hpp"
#include "tolman/geometry.hpp"

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
double angle(const Eigen::Isometry3d& motion) { return logSo3(motion.linear()).norm(); }
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
double usualLength(const Stretches& stretches, Eigen::Isometry3d Stretch::*motion) {
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
      const bool is_jump = score > worst && truthJumpsIn(i);
      if (!is_jump && !(score > worst && restartsIn(i))) continue;
      worst = score;
      const auto motion = [](const Eigen::Isometry3d& m) {
        return fmt::format("moves {:.3g} m and turns {:.3g} degrees", length(m),
                           angle(m) * 180 / std::numbers::pi);
      };
      text = fmt::format(
          "from frame {} to {} the truth {} and the estimate {}: {}", frame(at(i).first),
          frame(at(i).last), motion(at(i).truth), motion(at(i).estimate),
          is_jump ? "the truth jumps. Is a pose missing or wrong, or are its parts of different "
                    "drives? All errors are wrong if so"
                  : "the estimate starts again at its origin. Score its parts one by one; errors "
                    "over both say nothing");
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

  /// The longest time in which the truth (or the estimate) stands while the other moves.
  std::string standing(bool is_truth, std::size_t fewest) const {
    std::size_t best = 0, end = 0;
    for (std::size_t i = 0, run = 0; i < scores_.size(); ++i) {
      const bool joined = run > 0 && at(i).first == at(i - 1).last;
      run = !stands(i, is_truth) ? 0 : joined ? run + 1 : 1;
      if (run > best) best = run, end = i;
    }
    if (best < fewest) return "";
    const std::size_t first = at(end + 1 - best).first, last = at(end).last;
    const double way = distance(is_truth ? matches_.estimate : matches_.truth, first, last);
    const double usual = usual_ * (is_truth ? scale_ : 1) * static_cast<double>(best);
    if (way < kMoves * usual) return "";  // the drift of an estimate at a standstill
    return fmt::format("the {} stands still from frame {} to {} while the {} moves {:.3g} m: {}",
                       is_truth ? "truth" : "estimate", frame(first), frame(last),
                       is_truth ? "estimate" : "truth", way,
                       is_truth ? "are poses held or missing? All errors are wrong if so"
                                : "is odometry lost, or its sensor, without saying so?");
  }

  /// A frame from which on lengths are in another unit, steady before and after it.
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
    double left = HUGE_VAL;  // sum of squares about the means of both parts
    std::size_t best = 0;
    Statistics before, after;
    for (auto split = kFewest; split + kFewest <= std::ssize(ratios); ++split) {
      const Statistics a = statistics({ratios.begin(), ratios.begin() + split});
      const Statistics b = statistics({ratios.begin() + split, ratios.end()});
      const auto squares = [](const Statistics& s) {
        return static_cast<double>(s.count - 1) * s.deviation * s.deviation;
      };
      if (squares(a) + squares(b) >= left) continue;
      left = squares(a) + squares(b);
      best = static_cast<std::size_t>(split);
      before = a;
      after = b;
    }
    const double deviation = std::sqrt(left / static_cast<double>(ratios.size()));
    const double change = std::fabs(after.mean - before.mean);
    if (best == 0 || change < std::max(least, kOutlier * deviation)) return "";
    return fmt::format(
        "the estimate is {:.3g} times as long as the truth until frame {}, and {:.3g} times from "
        "there on: does the truth change its unit, or the estimate its scale? All errors are wrong "
        "if so",
        std::exp(before.mean), frame(pairs[best]), std::exp(after.mean));
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
  bool truthJumpsIn(std::size_t i) const {
    const auto way = [](const Stretch& s) { return length(s.truth); };
    const auto turn = [](const Stretch& s) { return angle(s.truth); };
    const bool jumps = scores_[i] < -kOutlier && way(at(i)) > kTimes * usual_;
    const bool turns = turns_[i] > kOutlier && turn(at(i)) > kTimes * angle(at(i).estimate);
    return (jumps && isAlone(i, way)) || (turns && isAlone(i, turn));
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

Stretches stretches(const Matches& matches, std::size_t steps) {
  Stretches result;
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

std::vector<std::size_t> stepCounts(const Matches& matches) {
  std::vector<std::size_t> counts;
  for (const std::size_t parts : {400U, 100U, 25U}) {
    counts.push_back(std::max<std::size_t>(1, matches.size() / parts));
  }
  counts.erase(std::ranges::unique(counts).begin(), counts.end());
  return counts;
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

namespace {

/// (R - I) arm = truth - estimate for each motion; R and both translations in camera axes.
Extrinsic armOf(const Stretches& motions) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Stretch& each : motions) {
    const Eigen::Matrix3d J = each.truth.linear() - Eigen::Matrix3d::Identity();
    information += J.transpose() * J;
    sum += J.transpose() * (each.truth.translation() - each.estimate.translation());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(information);
  Extrinsic extrinsic;
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();  // per squared residual
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d direction = parts.eigenvectors().col(i);
    const double strength = parts.eigenvalues()[i];
    const bool is_known = strength > 1e-9 * parts.eigenvalues()[2] && strength > 1e-12;
    if (is_known) extrinsic.arm += direction * direction.dot(sum) / strength;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = direction[axis] * direction[axis];
      if (is_known) variances[axis] += share / strength;
      if (!is_known && share > 0.01) variances[axis] = HUGE_VAL;
    }
  }
  double left = 1e-18;
  for (const Stretch& each : seenFrom(motions, extrinsic.R, extrinsic.arm)) {
    left += (each.truth.translation() - each.estimate.translation()).squaredNorm();
  }
  const double freedom = 3 * static_cast<double>(motions.size()) - 3;
  extrinsic.sigma = (variances * left / std::max(1.0, freedom)).cwiseSqrt();
  return extrinsic;
}

/// Axes and arm together, in turn.
Extrinsic axesAndArm(const Stretches& motions) {
  Extrinsic extrinsic;
  Stretches moved = motions;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d R = bestAxes(moved, 1);
    extrinsic = armOf(seenFrom(motions, R, Eigen::Vector3d::Zero()));
    extrinsic.R = R;
    moved = seenFrom(motions, Eigen::Matrix3d::Identity(), R.transpose() * extrinsic.arm);
  }
  return extrinsic;
}

/// The truth at the time of pair `i` and `offset` seconds later.
std::optional<PoseAt> truthAt(const Trajectory& truth, const Matches& matches, std::size_t i,
                              double offset) {
  return poseAt(truth, matches.estimate[i].stamp_ns + std::llround(offset * 1e9));
}

}  // namespace

Eigen::Matrix3d bestAxes(const Stretches& motions, double determinant) {
  Eigen::Matrix3d ways = Eigen::Matrix3d::Zero(), turns = ways;
  double lengths = 1e-30, angles = 1e-30;
  for (const Stretch& each : motions) {
    const Eigen::Vector3d true_turn = logSo3(each.truth.linear());
    const Eigen::Vector3d turn = logSo3(each.estimate.linear());
    ways += each.estimate.translation() * each.truth.translation().transpose();
    turns += turn * true_turn.transpose();
    lengths += each.estimate.translation().norm() * each.truth.translation().norm();
    angles += turn.norm() * true_turn.norm();
  }
  // A mirror turns the axes of rotations the other way. Then the orthogonal matrix with the largest
  // trace of products (Arun et al. 1987).
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(ways / lengths + determinant * turns / angles,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() * determinant < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

Stretches seenFrom(Stretches motions, const Eigen::Matrix3d& axes, const Eigen::Vector3d& arm) {
  for (Stretch& each : motions) {
    each.truth.linear() = axes * each.truth.linear() * axes.transpose();
    each.truth.translation() = axes * each.truth.translation() + arm - each.truth.linear() * arm;
  }
  return motions;
}

Extrinsic extrinsicOf(const Matches& matches, bool with_axes) {
  const auto weight = [](const Extrinsic& found) {  // of the directions that are known
    return found.sigma.unaryExpr([](double s) { return std::isfinite(s) ? s : 0; }).norm();
  };
  std::optional<Extrinsic> best;
  for (const std::size_t steps : stepCounts(matches)) {
    const Stretches motions = stretches(matches, steps);
    const Extrinsic found = with_axes ? axesAndArm(motions) : armOf(motions);
    if (!best || weight(found) < weight(*best)) best = found;
  }
  return *best;
}

Result<Extrinsic> parseBody(const std::string& text) {
  std::vector<double> v;
  for (const std::string_view word : text_encoding::splitFields(text)) {
    v.push_back(text_encoding::parseNumber(word).value_or(NAN));
  }
  const bool is_whole = v.size() == 7;
  const Eigen::Quaterniond q =
      is_whole ? Eigen::Quaterniond(v[6], v[3], v[4], v[5]) : Eigen::Quaterniond::Identity();
  const bool is_known = std::ranges::none_of(v, [](double value) { return std::isnan(value); });
  if ((!is_whole && v.size() != 3) || !is_known || std::fabs(q.norm() - 1) > 0.01) {
    return Status::invalidParameter(
        "give x,y,z in m or x,y,z,qx,qy,qz,qw with a quaternion of length 1, or estimate");
  }
  return Extrinsic{q.normalized().toRotationMatrix(), {v[0], v[1], v[2]}};
}

std::string armText(const Extrinsic& extrinsic) {
  std::vector<std::string> parts;
  for (int i = 0; i < 3; ++i) {
    const double arm = extrinsic.arm[i], sigma = extrinsic.sigma[i];
    parts.push_back(!std::isfinite(sigma) ? "unknown"
                    : extrinsic.sigma.isZero()
                        ? fmt::format("{:.3g}", arm)
                        : fmt::format("{0:.{2}f} +- {1:.{2}f}", arm, sigma, sigma < 0.005 ? 3 : 2));
  }
  return fmt::format("({}) m in the camera (x right, y down, z forward)", fmt::join(parts, ", "));
}

nlohmann::ordered_json toJson(const Extrinsic& body) {
  using Json = nlohmann::ordered_json;
  Json arm, sigma;
  for (int i = 0; i < 3; ++i) {
    const bool is_known = std::isfinite(body.sigma[i]);
    arm.push_back(is_known ? Json(body.arm[i]) : Json());
    sigma.push_back(is_known ? Json(body.sigma[i]) : Json());
  }
  const Eigen::Quaterniond q(body.R);
  return {{"arm_m", arm}, {"sigma_m", sigma}, {"quaternion_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
}

std::optional<Extrinsic> bodyOf(const Matches& matches) {
  constexpr double kTurned = 10 * std::numbers::pi / 180;
  constexpr std::size_t kFewest = 20;  // poses
  if (matches.size() < kFewest || !hasOrientations(matches.truth)) return std::nullopt;
  const Extrinsic body = extrinsicOf(matches, true);
  return logSo3(body.R).norm() > kTurned ? body : extrinsicOf(matches, false);
}

std::optional<ClockOffset> clockOffset(const Trajectory& truth, const Matches& matches,
                                       double longest_s) {
  constexpr std::size_t kMost = 1000, kFewest = 10;  // motions
  const Stretches all = stretches(matches, 1);
  if (all.size() < kFewest) return std::nullopt;
  Stretches motions;
  for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / kMost) motions.push_back(all[i]);
  const auto apart = [&](double offset) {  // mean squared difference of the angles of turns, rad^2
    double sum = 0;
    std::size_t count = 0;
    for (const Stretch& each : motions) {
      const auto from = truthAt(truth, matches, each.first, offset);
      const auto to = truthAt(truth, matches, each.last, offset);
      if (!from || !to) continue;
      const double turn = angle(from->T_world_camera.inverse() * to->T_world_camera);
      sum += std::pow(turn - angle(each.estimate), 2);
      ++count;
    }
    return 2 * count > motions.size() ? sum / static_cast<double>(count) : HUGE_VAL;
  };
  const auto seconds = [](const Trajectory& path) {
    return 1e-9 * static_cast<double>(path.back().stamp_ns - path.front().stamp_ns);
  };
  const double most = std::min(longest_s, seconds(truth) / 10);
  const double period = seconds(matches.estimate) / static_cast<double>(matches.size());
  const double step = std::max(period / 2, most / 200);
  double best = 0, least = apart(0);
  for (double offset = -most; offset <= most; offset += step) {
    const double now = apart(offset);
    if (now < least) least = now, best = offset;
  }
  double low = best - step, high = best + step;
  for (int i = 0; i < 25; ++i) {
    const double third = (high - low) / 3;
    const bool is_low = apart(low + third) < apart(high - third);
    (is_low ? high : low) += is_low ? -third : third;
  }
  best = (low + high) / 2;
  // The curvature of the sum of squares at its minimum gives the variance.
  const double left = apart(best);
  const double curvature = (apart(best - step) + apart(best + step) - 2 * left) / (step * step);
  const auto count = static_cast<double>(motions.size());
  return ClockOffset{best, std::sqrt(2 * left / (count * std::max(curvature, 1e-300)))};
}

Matches delayed(const Trajectory& truth, Matches matches, double offset) {
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto pose = truthAt(truth, matches, i, offset);
    if (pose) matches.truth[i].T_world_camera = pose->T_world_camera;
    if (!pose) matches.estimate[i].tracked = false;
  }
  return matches;
}

}  // namespace tolman::evaluation
