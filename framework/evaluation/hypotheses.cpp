// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/hypotheses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "evaluation/alignment.hpp"
#include "evaluation/errors.hpp"
#include "evaluation/truth_sensor.hpp"
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

using Motions = std::vector<Stretch>;
using Pose = Eigen::Isometry3d;

/// The estimate's motions scaled so that they fit the true ones best.
double bestScale(const Motions& motions) {
  double products = 0, squares = 0;
  for (const Stretch& each : motions) {
    products += each.truth.translation().dot(each.estimate.translation());
    squares += each.estimate.translation().squaredNorm();
  }
  return squares > 0 && products > 0 ? products / squares : 1;
}

void scaleEstimate(Motions& motions, double scale) {
  for (Stretch& each : motions) each.estimate.translation() *= scale;
}

bool explains(const Misfit& before, const Misfit& after, double noticeable) {
  const auto better = [&](double b, double a) {
    return b > noticeable && a < kExplained && a < kBetterShare * b;
  };
  const auto kept = [](double b, double a) { return a <= 1.25 * b + kNoticeable; };
  return (better(before.translation, after.translation) && kept(before.rotation, after.rotation)) ||
         (better(before.rotation, after.rotation) && kept(before.translation, after.translation));
}

Pose inverse(const Pose& T) { return T.inverse(); }

Pose transposed(const Pose& T) {
  Pose other = T;
  other.linear().transposeInPlace();
  return other;
}

/// x y z w, read from a file that has w x y z.
Pose reordered(const Pose& T) {
  const Eigen::Quaterniond q(T.linear());
  Pose other = T;
  other.linear() = Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()).toRotationMatrix();
  return other;
}

template <int axis>
Pose mirrored(const Pose& T) {
  Pose other = T;
  other.translation()[axis] *= -1;
  return other;
}

struct PoseReading {
  const char* text;
  Pose (*meant)(const Pose&);
};
constexpr std::array kPoseReadings = {
    PoseReading{"poses are world to camera", inverse},
    PoseReading{"rotations are world to camera (transposed), or angles have the wrong sign",
                transposed},
    PoseReading{"quaternions are in the order w x y z", reordered},
    PoseReading{"positions have the wrong sign in x", mirrored<0>},
    PoseReading{"positions have the wrong sign in y", mirrored<1>},
    PoseReading{"positions have the wrong sign in z", mirrored<2>},
};

Trajectory readAs(Trajectory path, const PoseReading& reading) {
  for (TrajectoryPose& pose : path) pose.T_world_camera = reading.meant(pose.T_world_camera);
  return path;
}

double angleOf(const Eigen::Matrix3d& R) {
  return Eigen::AngleAxisd(R).angle() * 180 / std::numbers::pi;
}

std::string armText(const Extrinsic& extrinsic) {
  std::vector<std::string> parts;
  for (int i = 0; i < 3; ++i) {
    const bool is_known = std::isfinite(extrinsic.sigma[i]);
    parts.push_back(is_known ? fmt::format("{:.2f} +- {:.2f}", extrinsic.arm[i], extrinsic.sigma[i])
                             : "unknown");
  }
  return fmt::format("({}) m in the camera (x right, y down, z forward)", fmt::join(parts, ", "));
}

Matches reversed(Matches matches) {
  Trajectory& truth = matches.truth;
  for (std::size_t i = 0; i < truth.size() / 2; ++i) {
    std::swap(truth[i].T_world_camera, truth[truth.size() - 1 - i].T_world_camera);
  }
  return matches;
}

/// Each of both paths beside a vehicle that goes as far, but always in the mean direction of its
/// body. Only few cameras do not: those that are carried or flown.
Motions besideVehicles(const Motions& motions) {
  Motions result;
  for (const auto path : {&Stretch::truth, &Stretch::estimate}) {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    for (const Stretch& each : motions) direction += (each.*path).translation();
    direction.normalize();
    for (const Stretch& each : motions) {
      Pose vehicle = each.*path;
      vehicle.translation() = vehicle.translation().norm() * direction;
      result.push_back({each.first, each.last, each.*path, vehicle});
    }
  }
  return result;
}

/// Orientations that do not belong to the positions are replaced by those of the estimate.
Matches withEstimatedOrientations(Matches matches, std::size_t steps) {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (const Stretch& each : stretches(matches, steps)) {
    const auto way = [&](const Trajectory& path) -> Eigen::Vector3d {
      return path[each.last].T_world_camera.translation() -
             path[each.first].T_world_camera.translation();
    };
    products += way(matches.truth) * way(matches.estimate).transpose();
  }
  const Eigen::Matrix3d R = bestOrthogonal(products);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    matches.truth[i].T_world_camera.linear() = R * matches.estimate[i].T_world_camera.linear();
  }
  return matches;
}

/// Root mean square position error, m, after an alignment.
double alignedError(const Matches& matches) {
  const auto similarity = align(matches, Alignment::Se3);
  return similarity.isOk() ? absoluteError(aligned(matches, similarity.value())).rmse : 0;
}

/// Collects the hypotheses that hold.
class Table {
 public:
  Table(const Trajectory& truth, const Matches& matches, bool free_scale, bool by_stamp)
      : matches_(matches),
        time_(truth, matches, by_stamp),
        free_scale_(free_scale),
        offset_(clockOffset(time_, matches)),
        arm_(extrinsicOf(matches, false)),
        body_(extrinsicOf(matches, true)) {}

  void tryAll(std::size_t steps) {
    steps_ = steps;
    as_read_ = stretches(matches_, steps);
    if (as_read_.size() < kFewestStretches) return;
    before_ = misfitOf(as_read_, free_scale_);
    tryPoses();
    tryBodies();
    if (!free_scale_) tryLengths();
    tryTime();
    tryBoth();
    tryPositions();
  }

  std::vector<Hypothesis> result() && {
    std::ranges::stable_sort(found_, {}, [](const Hypothesis& h) { return h.after.whole(); });
    std::vector<Hypothesis> best;
    for (Hypothesis& each : found_) {
      const auto same = [&](const Hypothesis& other) { return other.name == each.name; };
      if (std::ranges::any_of(best, same)) continue;
      const double least = best.empty() ? HUGE_VAL : best.front().after.whole();
      if (each.after.whole() > std::max(2 * least, least + 0.02)) continue;
      best.push_back(std::move(each));
    }
    if (best.size() > 1) std::erase_if(best, [](const auto& h) { return h.name == kPositions; });
    return best;
  }

 private:
  static constexpr const char* kPositions = "positions";

  void add(std::string name, std::string text, const Motions& motions,
           double noticeable = kNoticeable) {
    consider(std::move(name), std::move(text), before_, misfitOf(motions, free_scale_), noticeable);
  }
  void consider(std::string name, std::string text, const Misfit& before, const Misfit& after,
                double noticeable = kNoticeable) {
    if (!explains(before, after, noticeable)) return;
    found_.push_back({std::move(name), std::move(text), before, after});
  }

  void tryPoses() {
    for (const PoseReading& reading : kPoseReadings) {
      for (const char* which : {"the true ", "the estimated "}) {
        Matches other = matches_;
        Trajectory& path = which[4] == 't' ? other.truth : other.estimate;
        path = readAs(path, reading);
        const std::string text = std::string(which) + reading.text;
        add(text, text, stretches(other, steps_));
      }
    }
    add("order", "the true poses are in reverse order", stretches(reversed(matches_), steps_));
  }

  void tryBodies() {
    const Eigen::Matrix3d axes = bestAxes(as_read_, 1);
    add("axes",
        fmt::format("the truth is of a body whose axes are turned by {:.0f} degrees against those "
                    "of the camera (x right, y down, z forward)",
                    angleOf(axes)),
        turned(as_read_, axes));
    add("mirror", "one of the two has left-handed axes, or an axis of the wrong sign",
        turned(as_read_, bestAxes(as_read_, -1)));
  }

  void tryLengths() {
    constexpr double kUnits = 1.5;  // odometry drifts by less
    const double scale = bestScale(as_read_);
    if (scale * kUnits < 1 || scale > kUnits) {
      Motions scaled = as_read_;
      scaleEstimate(scaled, scale);
      add("scale",
          fmt::format("the estimate is multiplied by {:.3g} (units of one of the two, or the "
                      "baseline of the cameras)",
                      scale),
          scaled);
    }
    if (armExplains()) {
      add("arm", "the truth is of a point at " + armText(arm_), shifted(as_read_, arm_.arm), 0.02);
    }
    constexpr double kTurned = 10;  // degrees; else it is the point alone
    if (angleOf(body_.R) < kTurned) return;
    add("body",
        fmt::format("the truth is of a body at {} whose axes are turned by {:.0f} degrees",
                    armText(body_), angleOf(body_.R)),
        shifted(turned(as_read_, body_.R), body_.arm));
  }

  /// An arm turns with the vehicle, so that it is a small part of its motion, and clear in
  /// positions.
  bool armExplains() const {
    Matches moved = matches_;
    for (TrajectoryPose& pose : moved.truth) {
      pose.T_world_camera.translation() -= pose.T_world_camera.linear() * arm_.arm;
    }
    return alignedError(moved) < kArm * alignedError(matches_);
  }

  void tryTime() {
    if (!offset_) return;
    const std::string text =
        time_.inFrames() ? fmt::format("the truth is given {:.1f} frames {}", std::fabs(*offset_),
                                       *offset_ < 0 ? "early" : "late")
                         : fmt::format("the clock of the estimate is {:.3f} s {} that of the truth",
                                       std::fabs(*offset_), *offset_ < 0 ? "ahead of" : "behind");
    const Misfit after =
        misfitOf(stretches(delayed(time_, matches_, *offset_), steps_), free_scale_);
    if (after.rotation < kBetterShare * before_.rotation) consider("time", text, before_, after);
  }

  void tryBoth() {
    constexpr double kAllDirections = 1;
    const auto lengthOf = [](const Motions& motions) {
      double sum = 0;
      for (const Stretch& each : motions) sum += each.truth.translation().norm();
      return sum;
    };
    const Misfit as_read = misfitOf(besideVehicles(as_read_), false);
    for (const PoseReading& reading : {kPoseReadings[0], kPoseReadings[1]}) {
      Matches other = matches_;
      other.truth = readAs(other.truth, reading);
      other.estimate = readAs(other.estimate, reading);
      const Motions meant = stretches(other, steps_);
      // Turns at a distance from the origin make a path of inverted poses longer, never shorter.
      if (lengthOf(meant) > 1.001 * lengthOf(as_read_)) continue;
      consider(reading.text, std::string("in both files ") + reading.text, as_read,
               misfitOf(besideVehicles(meant), false), kAllDirections);
    }
  }

  /// The last resort: any other hypothesis that holds says more.
  void tryPositions() {
    const Misfit after =
        misfitOf(stretches(withEstimatedOrientations(matches_, steps_), steps_), free_scale_);
    consider(kPositions,
             "only positions are compared: the orientations of one of the two are wrong",
             {before_.translation, 0}, {after.translation, 0});
  }

  const Matches& matches_;
  TruthOverTime time_;
  bool free_scale_;
  std::optional<double> offset_;
  Extrinsic arm_;
  Extrinsic body_;
  std::size_t steps_ = 1;
  Motions as_read_;
  Misfit before_;
  std::vector<Hypothesis> found_;
};

}  // namespace

double Misfit::whole() const { return std::hypot(translation, rotation); }

Misfit misfitOf(Motions motions, bool free_scale) {
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

std::vector<Hypothesis> misreadings(const Trajectory& truth, const Matches& matches,
                                    bool free_scale, bool by_stamp) {
  if (matches.size() < kFewestStretches) return {};
  Table table(truth, matches, free_scale, by_stamp);
  for (const std::size_t steps : stepCounts(matches)) table.tryAll(steps);
  return std::move(table).result();
}

}  // namespace tolman::evaluation
