// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/axes_hint.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "evaluation/alignment.hpp"
#include "evaluation/errors.hpp"
#include "evaluation/turns.hpp"

namespace tolman::evaluation {
namespace {

constexpr double kApart = 45 * kDegree;
constexpr double kNearAxis = 15 * kDegree;

Eigen::Vector3d step(const Trajectory& path, std::size_t from, std::size_t to) {
  return (path[from].T_world_camera.inverse() * path[to].T_world_camera).translation();
}
Eigen::Vector3d step(const Trajectory& path, std::size_t i) { return step(path, i - 1, i); }

/// Sums over all steps, weighted by length: a camera at rest has no direction of motion.
struct Steps {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  ///< of true and estimated steps
  double lengths = 0;                                  ///< products of their lengths
};

/// A step ends where the truth has moved by `least` m.
Steps stepsOf(const Trajectory& truths, const Trajectory& estimates, double least = 0) {
  Steps sums;
  for (std::size_t begin = 0, i = 1; i < truths.size(); ++i) {
    if (!estimates[i].tracked) begin = i;
    const Eigen::Vector3d truth = step(truths, begin, i);
    if (begin == i || truth.norm() < least) continue;
    const Eigen::Vector3d estimate = step(estimates, begin, i);
    sums.products += truth * estimate.transpose();
    sums.lengths += truth.norm() * estimate.norm();
    begin = i;
  }
  return sums;
}

Trajectory inverted(Trajectory path) {
  for (TrajectoryPose& pose : path) pose.T_world_camera = pose.T_world_camera.inverse();
  return path;
}

/// Sums over all turns in rad, each in the axes of its camera.
struct Turns {
  double products = 0;  ///< of true and estimated turns
  double truths = 0;    ///< squares
  double estimates = 0;
  double angle = 0;  ///< of the true ones
  int count = 0;

  void add(const Eigen::Vector3d& truth, const Eigen::Vector3d& estimate) {
    products += truth.dot(estimate);
    truths += truth.squaredNorm();
    estimates += estimate.squaredNorm();
    angle += truth.norm();
    ++count;
  }
};

Turns turnsOf(const Matches& matches) {
  Turns sums;
  visitTurns(matches, [&](const Eigen::Vector3d& truth, const Eigen::Vector3d& estimate) {
    sums.add(truth, estimate);
  });
  return sums;
}

/// Angle whose cosine is the mean of cosines, weighted by length.
double meanAngle(double sum, const Steps& steps) {
  return std::acos(std::min(1.0, std::max(-1.0, sum / steps.lengths)));
}

/// Mean angle between the directions of true and estimated motion, rad; 0 for too few steps.
double directionsApart(const Matches& matches, const Steps& steps) {
  constexpr std::size_t kMin = 10;  // frames
  if (matches.size() < kMin || !(steps.lengths > 0)) return 0;
  return meanAngle(steps.products.trace(), steps);
}

/// Median angle between true and estimated orientation, rad.
double orientationsApart(const Matches& aligned) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < aligned.truth.size(); ++i) {
    if (!aligned.estimate[i].tracked) continue;
    const Eigen::Matrix3d turn = aligned.truth[i].T_world_camera.linear().transpose() *
                                 aligned.estimate[i].T_world_camera.linear();
    angles.push_back(Eigen::AngleAxisd(turn).angle());
  }
  if (angles.empty()) return 0;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::ranges::nth_element(angles, middle);
  return *middle;
}

constexpr double kAgree = 0.05;  // of the true path
constexpr double kReversed = 90 * kDegree;

/// Root mean square position error after the estimate is turned about its mean position so that
/// its orientations agree with the true ones, m.
double errorWithOrientations(const Matches& aligned) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < aligned.truth.size(); ++i) {
    sum += aligned.truth[i].T_world_camera.linear() *
           aligned.estimate[i].T_world_camera.linear().transpose();
    mean += aligned.estimate[i].T_world_camera.translation();
  }
  mean /= static_cast<double>(aligned.truth.size());
  const Eigen::Matrix3d turn = Eigen::Affine3d(sum).rotation();  // nearest rotation
  const Similarity about_mean{1, turn, mean - turn * mean};
  return absoluteError(evaluation::aligned(aligned, about_mean)).rmse;
}

/// Whether the positions hardly determine the turn that contradicts the orientations.
bool isTurnedFreely(const Matches& aligned) {
  constexpr double kFree = 0.01;  // of the true path; 0.002 on the first metres of KITTI 06
  constexpr double kTimes = 3;    // the error of the alignment; chosen, not tuned
  return orientationsApart(aligned) > kReversed &&
         errorWithOrientations(aligned) <=
             std::max(kFree * pathLength(aligned.truth), kTimes * absoluteError(aligned).rmse);
}

}  // namespace

std::string axesHint(const Matches& matches) {
  const Steps steps = stepsOf(matches.truth, matches.estimate);
  const double apart = directionsApart(matches, steps);
  if (apart < kApart) return "";
  const Steps other = stepsOf(inverted(matches.truth), matches.estimate);
  // On a straight path, and on a circle, inverted and reversed poses are alike.
  const bool backwards = meanAngle(-steps.products.trace(), steps) < kNearAxis;
  if (meanAngle(other.products.trace(), other) < kNearAxis) {
    return fmt::format(
        "the true poses, read as world to camera, agree with the estimate, and as camera to world "
        "they do not: write camera-to-world poses{}. All errors are wrong until then",
        backwards ? ", or, if they are that, give them in the order of the frames: read as they "
                    "are they drive backwards, as in reverse order"
                  : "");
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(steps.products,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Eigen::Vector3d& s = svd.singularValues();
  const double together = meanAngle(s[0] + s[1] + sign * s[2], steps);
  if (together > kNearAxis) return "";
  return fmt::format(
      "true and estimated motion point in directions {:.0f} degrees apart, but in the same way "
      "all along: are the true poses camera to world, of the left camera (x right, y down, z "
      "forward), with quaternions as x y z w{}? Rotation errors, drift and NEES are wrong if not",
      apart / kDegree, backwards ? ", and in the order of the frames" : "");
}

std::string turnHint(const Matches& matches) {
  constexpr double kOpposite = -0.8;  // mirrored KITTI 05 and 07 have -0.998; chosen, not tuned
  constexpr int kFewest = 10;         // a straight road says nothing, a poor estimate little
  const Turns turns = turnsOf(matches);
  const double scale = std::sqrt(turns.truths * turns.estimates);
  if (turns.count < kFewest || !(turns.products < kOpposite * scale)) return "";
  return fmt::format(
      "the truth turns the other way than the estimate (a correlation of {:.3f} over {:.0f} "
      "degrees): does an axis or the angle of one of the two have the wrong sign? In files of "
      "motion in the plane y is left and angles are counterclockwise. All errors are wrong if so",
      turns.products / scale, turns.angle / kDegree);
}

std::string rotationHint(const Matches& aligned) {
  constexpr double kClear = 5;  // times the error: noise turns such steps little; chosen, not tuned
  const double error = absoluteError(aligned).rmse;
  if (error > kAgree * pathLength(aligned.truth)) return "";
  const double apart =
      directionsApart(aligned, stepsOf(aligned.truth, aligned.estimate, kClear * error));
  const double turned = orientationsApart(aligned);
  if (apart < kApart && turned > kReversed && !isTurnedFreely(aligned)) {
    return fmt::format(
        "the positions agree only where the alignment turns the estimate by {:.0f} degrees against "
        "its own orientations: does an axis of the positions of one of the two have the wrong "
        "sign? Position errors say nothing if so",
        turned / kDegree);
  }
  if (apart < kApart) return "";
  return fmt::format(
      "the positions agree, but true and estimated motion, each in the axes of its camera, point "
      "in directions {:.0f} degrees apart: the rotations of one of the two are wrong. Are the "
      "quaternions in the order x y z w, and the poses camera to world? Rotation errors and drift "
      "are wrong if not",
      apart / kDegree);
}

std::string upHint(const Trajectory& truth) {
  constexpr double kAlongX = 0.9;  // of the path; chosen, not tuned
  constexpr double kMoreY = 2;     // extent along y over that along z; chosen, not tuned
  if (truth.empty()) return "";
  double length = 0, along_x = 0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    length += step(truth, i).norm();
    along_x += std::fabs(step(truth, i).x());
  }
  const Eigen::Isometry3d T_first_world = truth.front().T_world_camera.inverse();
  Eigen::AlignedBox3d box;
  for (const TrajectoryPose& pose : truth) {
    box.extend((T_first_world * pose.T_world_camera).translation());
  }
  const Eigen::Vector3d size = box.sizes();
  if (!(along_x > kAlongX * length) || !(size.y() > kMoreY * size.z())) return "";
  return fmt::format(
      "the true poses move along their own x axis, and more along the y axis of the first one "
      "({:.3g} m) than along its z axis ({:.3g} m), as poses with x forward and z up do, and y is "
      "taken as down: give poses of the camera (x right, y down, z forward)",
      size.y(), size.z());
}

std::string unitHint(const Matches& matches) {
  constexpr double kFactor = 50;
  constexpr double kMin = 0.1;  // m; the ratio of shorter paths is not meaningful
  const double truth = pathLength(matches.truth);
  const double estimate = pathLength(matches.estimate);
  constexpr double kShort = 2.0 / 3;  // noise makes a path longer, never shorter; chosen, not tuned
  if (truth >= 1 && estimate < 1e-6 * truth) return "the estimate does not move";
  if (std::min(truth, estimate) < kMin) return "";
  // Noise makes the truth of a slow robot several times as long.
  constexpr double kAgreement = 0.02;  // of the shorter path; chosen, not tuned
  if (absoluteError(matches).rmse < kAgreement * std::min(truth, estimate)) return "";
  if (truth >= 1 && estimate < kShort * truth && estimate * kFactor > truth) {
    return fmt::format(
        "the estimated path is only {:.3g} times as long as the true one; the scale of a single "
        "camera is not known: align with sim3, or look for gaps in tracking",
        estimate / truth);
  }
  if (std::max(truth, estimate) < kFactor * std::min(truth, estimate)) return "";
  return fmt::format(
      "the true path is {:.3g} times as long as the estimated one: are the positions of both in "
      "metres?",
      truth / estimate);
}

std::string speedHint(const Matches& matches) {
  constexpr double kFastest = 1000;  // m/s, 3600 km/h: chosen; no aircraft with a camera is faster
  const Trajectory& timed = hasStamps(matches.truth) ? matches.truth : matches.estimate;
  std::vector<double> speeds;
  for (std::size_t i = 1; i < timed.size(); ++i) {
    const double seconds = 1e-9 * static_cast<double>(timed[i].stamp_ns - timed[i - 1].stamp_ns);
    if (seconds > 0) speeds.push_back(step(matches.truth, i).norm() / seconds);
  }
  if (speeds.empty()) return "";
  const double median = statistics(speeds).median;
  if (median <= kFastest) return "";
  return fmt::format(
      "by the stamps the true path is driven at {:.3g} m/s (median), faster than any vehicle: are "
      "its positions in metres, and the stamps in seconds?",
      median);
}

std::string scaleHint(const Matches& matches) {
  constexpr double kFactor = 1.5;      // odometry drifts by less; chosen, not tuned
  constexpr double kAgreement = 0.02;  // of the true path; chosen, not tuned
  constexpr double kMin = 1;           // m; shorter paths say nothing
  const double truth = pathLength(matches.truth);
  if (truth < kMin) return "";
  const Result<Similarity> similarity = align(matches, Alignment::Sim3);
  if (!similarity.isOk()) return "";
  const double scale = similarity.value().scale;
  if (scale < kFactor && scale * kFactor > 1) return "";
  const double error = absoluteError(aligned(matches, similarity.value())).rmse;
  if (!(error < kAgreement * truth)) return "";
  return fmt::format(
      "the estimate is the true path but for its scale: multiplied by {:.3g} it agrees within "
      "{:.2g} m; are the baseline of the cameras and the units of both paths right?",
      scale, error);
}

}  // namespace tolman::evaluation
