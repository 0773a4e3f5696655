// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "evaluation/association.hpp"
#include "evaluation/errors.hpp"
#include "evaluation/score.hpp"
#include "evaluation/step_series.hpp"
#include "tolman/geometry.hpp"

namespace tolman::evaluation {

namespace {

// Chosen on ORB-SLAM2 and S-PTAM on KITTI 00, and the reference runs on KITTI, the town, a lecture
// hall and TUM, of which none may be doubted. S-PTAM agrees twice as well a frame later.
constexpr double kNoticeable = 0.06;  // a smaller misfit needs no explanation: 3.4 degrees, or 6 %
constexpr double kExplained = 0.25;   // a larger one is no agreement
constexpr double kBetterShare = 1.0 / 3;      // of the misfit as read
constexpr double kArm = 0.25;                 // of the position error, if an arm is its main cause
constexpr std::size_t kFewestStretches = 10;  // stretches

/// Root mean square difference of true and estimated motions, relative to the motions themselves: 0
/// for equal ones, about 1.4 for unrelated ones.
struct Misfit {
  double translation = 0;
  double rotation = 0;
  double whole() const { return std::hypot(translation, rotation); }
};

/// A way of reading the poses under which truth and estimate agree. `name` is that of the row of
/// the table, the same for all lengths of stretches.
struct Hypothesis {
  std::string name;
  std::string text;  ///< "the true poses are world to camera"
  Misfit before{};   ///< of the poses as they are read
  Misfit after{};
};

using Pose = Eigen::Isometry3d;

/// The estimate's motions scaled so that they fit the true ones best.
double bestScale(const Stretches& motions) {
  double products = 0, squares = 0;
  for (const Stretch& each : motions) {
    products += each.truth.translation().dot(each.estimate.translation());
    squares += each.estimate.translation().squaredNorm();
  }
  return squares > 0 && products > 0 ? products / squares : 1;
}

void scaleEstimate(Stretches& motions, double scale) {
  for (Stretch& each : motions) each.estimate.translation() *= scale;
}

/// `free_scale`: after the scale that fits best.
Misfit misfitOf(Stretches motions, bool free_scale) {
  if (free_scale) scaleEstimate(motions, bestScale(motions));
  double lengths = 0, apart = 0, angles = 0, turned = 0;
  for (const Stretch& each : motions) {
    const auto& [truth, estimate] = std::tie(each.truth, each.estimate);
    lengths += truth.translation().squaredNorm() + estimate.translation().squaredNorm();
    apart += (truth.translation() - estimate.translation()).squaredNorm();
    angles += logSo3(truth.linear()).squaredNorm() + logSo3(estimate.linear()).squaredNorm();
    turned += logSo3(truth.linear().transpose() * estimate.linear()).squaredNorm();
  }
  const auto relative = [&](double part, double whole, double least) {
    return whole > least * static_cast<double>(motions.size()) ? std::sqrt(2 * part / whole) : 0;
  };
  return {relative(apart, lengths, 1e-18), relative(turned, angles, 1e-12)};
}

bool explains(const Misfit& before, const Misfit& after, double noticeable) {
  const auto better = [&](double b, double a) {
    return b > noticeable && a < kExplained && a < kBetterShare * b;
  };
  const auto kept = [](double b, double a) { return a <= 1.25 * b + kNoticeable; };
  return (better(before.translation, after.translation) && kept(before.rotation, after.rotation)) ||
         (better(before.rotation, after.rotation) && kept(before.translation, after.translation));
}

/// What single poses may be instead of what is read.
struct PoseReading {
  const char* text;
  void (*mend)(Pose&);
};
constexpr std::array kPoseReadings = {
    PoseReading{"poses are world to camera", [](Pose& T) { T = T.inverse(); }},
    PoseReading{"rotations are world to camera (transposed), or angles have the wrong sign",
                [](Pose& T) { T.linear().transposeInPlace(); }},
    PoseReading{"quaternions are in the order w x y z",  // read as x y z w
                [](Pose& T) {
                  const Eigen::Quaterniond q(T.linear());
                  T.linear() = Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()).toRotationMatrix();
                }},
    PoseReading{"positions have the wrong sign in x", [](Pose& T) { T.translation().x() *= -1; }},
    PoseReading{"positions have the wrong sign in y", [](Pose& T) { T.translation().y() *= -1; }},
    PoseReading{"positions have the wrong sign in z", [](Pose& T) { T.translation().z() *= -1; }},
};

double angleOf(const Eigen::Matrix3d& R) { return logSo3(R).norm() * 180 / std::numbers::pi; }

/// Root mean square position error, m, after an alignment.
double alignedError(const Matches& matches) {
  const auto similarity = align(matches, Alignment::Se3);
  return similarity.isOk() ? absoluteError(aligned(matches, similarity.value())).rmse : 0;
}

/// The table of hypotheses, over stretches of several lengths.
class Table {
 public:
  /// `by_stamp`: estimates have their own stamps, else those of their true poses. Frames are the
  /// seconds of a truth without stamps.
  Table(Trajectory truth, Matches matches, bool free_scale, bool by_stamp)
      : truth_(std::move(truth)), matches_(std::move(matches)), free_scale_(free_scale) {
    constexpr double kSeconds = 2, kFrames = 20;  // largest offset
    in_frames_ = !hasStamps(truth_);
    for (Trajectory* path : {&truth_, &matches_.truth}) {
      for (TrajectoryPose& pose : *path) {
        if (in_frames_) pose.stamp_ns = 1'000'000'000 * pose.frame;
      }
    }
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      if (in_frames_ || !by_stamp) matches_.estimate[i].stamp_ns = matches_.truth[i].stamp_ns;
    }
    offset_ = clockOffset(truth_, matches_, in_frames_ ? kFrames : kSeconds);
    arm_ = extrinsicOf(matches_, false);
    body_ = extrinsicOf(matches_, true);
    for (const std::size_t steps : stepCounts(matches_)) {
      as_read_ = stretches(matches_, steps);
      if (as_read_.size() < kFewestStretches) continue;
      before_ = misfitOf(as_read_, free_scale_);
      tryPoses(steps);
      tryBodies();
      if (!free_scale_) tryLengths();
      if (offset_) tryTime(steps);
    }
  }

  /// Those that hold, best first; of those that are far worse than the best one none.
  std::vector<Hypothesis> result() && {
    std::ranges::stable_sort(found_, {}, [](const Hypothesis& h) { return h.after.whole(); });
    std::vector<Hypothesis> best;
    for (Hypothesis& each : found_) {
      const double least = best.empty() ? HUGE_VAL : best.front().after.whole();
      const bool is_known = std::ranges::find(best, each.name, &Hypothesis::name) != best.end();
      if (is_known || each.after.whole() > std::max(2 * least, least + 0.02)) continue;
      best.push_back(std::move(each));
    }
    return best;
  }

 private:
  void add(const std::string& name, const std::string& text, const Stretches& motions,
           double noticeable = kNoticeable) {
    const Misfit after = misfitOf(motions, free_scale_);
    if (explains(before_, after, noticeable)) found_.push_back({name, text, before_, after});
  }

  void tryPoses(std::size_t steps) {
    for (const PoseReading& reading : kPoseReadings) {
      for (const bool is_truth : {true, false}) {
        Matches other = matches_;
        for (TrajectoryPose& pose : is_truth ? other.truth : other.estimate) {
          reading.mend(pose.T_world_camera);
        }
        const std::string text =
            std::string(is_truth ? "the true " : "the estimated ") + reading.text;
        add(text, text, stretches(other, steps));
      }
    }
    Matches reversed = matches_;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      reversed.truth[i].T_world_camera = matches_.truth[matches_.size() - 1 - i].T_world_camera;
    }
    add("order", "the true poses are in reverse order", stretches(reversed, steps));
  }

  void tryBodies() {
    const Eigen::Matrix3d axes = bestAxes(as_read_, 1);
    const Eigen::Vector3d here = Eigen::Vector3d::Zero();
    add("axes",
        fmt::format("the truth is of a body whose axes are turned by {:.0f} degrees against those "
                    "of the camera (x right, y down, z forward)",
                    angleOf(axes)),
        seenFrom(as_read_, axes, here));
    add("mirror", "one of the two has left-handed axes, or an axis of the wrong sign",
        seenFrom(as_read_, bestAxes(as_read_, -1), here));
  }

  void tryLengths() {
    constexpr double kUnits = 1.5;  // odometry drifts by less
    constexpr double kTurned = 10;  // degrees; else it is the point alone
    const double scale = bestScale(as_read_);
    if (scale * kUnits < 1 || scale > kUnits) {
      Stretches scaled = as_read_;
      scaleEstimate(scaled, scale);
      add("scale",
          fmt::format("the estimate is multiplied by {:.3g} (units of one of the two, or the "
                      "baseline of the cameras)",
                      scale),
          scaled);
    }
    // An arm is a small part of the motion of a vehicle, but clear in its positions.
    Matches moved = matches_;
    moved.truth = ofBody(std::move(moved.truth), Pose(Eigen::Translation3d(-arm_.arm)));
    if (alignedError(moved) < kArm * alignedError(matches_)) {
      add("arm", "the truth is of a point at " + armText(arm_),
          seenFrom(as_read_, arm_.R, arm_.arm), 0.02);
    }
    if (angleOf(body_.R) < kTurned) return;
    add("body",
        fmt::format("the truth is of a body at {} whose axes are turned by {:.0f} degrees",
                    armText(body_), angleOf(body_.R)),
        seenFrom(as_read_, body_.R, body_.arm));
  }

  void tryTime(std::size_t steps) {
    const double late = offset_->seconds;
    const std::string text =
        in_frames_ ? fmt::format("the truth is given {:.1f} frames {}", std::fabs(late),
                                 late < 0 ? "early" : "late")
                   : fmt::format("the clock of the estimate is {:.3f} s {} that of the truth",
                                 std::fabs(late), late < 0 ? "ahead of" : "behind");
    const Stretches motions = stretches(delayed(truth_, matches_, late), steps);
    if (misfitOf(motions, free_scale_).rotation < kBetterShare * before_.rotation) {
      add("time", text, motions);
    }
  }

  Trajectory truth_;
  Matches matches_;
  bool free_scale_;
  bool in_frames_ = false;
  std::optional<ClockOffset> offset_;
  Extrinsic arm_;
  Extrinsic body_;
  Stretches as_read_;
  Misfit before_;
  std::vector<Hypothesis> found_;
};

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

/// `by_stamp`: estimates have their own stamps, else those of their true poses.
std::string misreadingText(const Trajectory& truth, const Matches& matches, bool free_scale,
                           bool by_stamp) {
  if (matches.size() < kFewestStretches) return "";
  const auto hypotheses = Table(truth, matches, free_scale, by_stamp).result();
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
  Stretches within, across;
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
                                const Protocol& protocol) {
  const Alignment alignment = protocol.alignment.kind;
  Matching matching = protocol.matching;
  const bool by_stamp = matching.rule != MatchRule::Order;
  // Poses that repeat would seem to stand still.
  if (by_stamp && matching.rule != MatchRule::Interpolate) matching.rule = MatchRule::Nearest;
  const Result<Matches> found = associate(truth, estimate, matching);
  if (!found.isOk()) return {};
  const Matches& matches = found.value();
  if (std::string still = stillText(matches); !still.empty()) return {still};
  const bool free_scale =
      alignment == Alignment::Sim3 || protocol.alignment.scale != ScaleRule::Keep;
  std::vector<std::string> texts;
  if (!hasPositionsAlone(matches)) {
    texts.push_back(misreadingText(truth, matches, free_scale, by_stamp));
  }
  std::ranges::move(breaksOf(matches), std::back_inserter(texts));
  texts.push_back(sessionText(matches, free_scale));
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
