// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/turned_axes.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "evaluation/turns.hpp"

namespace tolman::evaluation {
namespace {

/// Sums over vectors of the truth and of the estimate: their mean angle, weighted by length, and
/// what is left of it after a rotation.
class Directions {
 public:
  void add(const Eigen::Vector3d& truth, const Eigen::Vector3d& estimate) {
    products_ += truth * estimate.transpose();
    lengths_ += truth.norm() * estimate.norm();
    ++count_;
  }
  int count() const { return count_; }
  Eigen::Matrix3d weighted() const {
    return lengths_ > 0 ? Eigen::Matrix3d(products_ / lengths_) : Eigen::Matrix3d::Zero();
  }
  /// rad, where the estimate is turned first; 0 without vectors.
  double apart(const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) const {
    if (!(lengths_ > 0)) return 0;
    return std::acos(std::clamp((weighted() * turn.transpose()).trace(), -1.0, 1.0));
  }

 private:
  Eigen::Matrix3d products_ = Eigen::Matrix3d::Zero();
  double lengths_ = 0;
  int count_ = 0;
};

/// The rotation R that makes the trace of products R' largest (Arun et al. 1987).
Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& products) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

Eigen::Vector3d wayBetween(const TrajectoryPose& from, const TrajectoryPose& to) {
  return (from.T_world_camera.inverse() * to.T_world_camera).translation();
}

struct Motions {
  Directions ways;
  Directions turns;
};

Motions motionsOf(const Matches& matches) {
  Motions motions;
  for (std::size_t i = 1; i < matches.size(); ++i) {
    if (!isTrackedStep(matches, i)) continue;
    motions.ways.add(wayBetween(matches.truth[i - 1], matches.truth[i]),
                     wayBetween(matches.estimate[i - 1], matches.estimate[i]));
  }
  visitTurns(matches, [&](const Eigen::Vector3d& truth, const Eigen::Vector3d& estimate) {
    motions.turns.add(truth, estimate);
  });
  return motions;
}

/// Whether a rotation leaves less than half of an angle that is not small.
bool isTurned(const Directions& directions, const Eigen::Matrix3d& turn, double least) {
  constexpr int kFewest = 10;
  // Chosen on KITTI 00 (ORB-SLAM2, truth turned by 5 degrees); no alarm on EuRoC, TUM, TUM-VI.
  constexpr double kLeft = 0.5;
  const double apart = directions.apart();
  return directions.count() >= kFewest && apart > least && directions.apart(turn) < kLeft * apart;
}

}  // namespace

std::string turnedAxesHint(const Matches& matches) {
  constexpr double kWays = 4 * kDegree;    // chosen and judged as kLeft
  constexpr double kTurns = 15 * kDegree;  // chosen, not tuned
  const auto [ways, turns] = motionsOf(matches);
  const Eigen::Matrix3d turn = bestRotation(ways.weighted() + turns.weighted());
  if (!isTurned(ways, turn, kWays) && !isTurned(turns, turn, kTurns)) return "";
  return fmt::format(
      "the camera of the truth is turned against that of the estimate: motions point in directions "
      "{:.0f} degrees apart and turns have axes {:.0f} degrees apart, in the same way all along. "
      "Give true poses of the left camera (x right, y down, z forward), or look for a wrong "
      "calibration; rotation errors, drift and NEES are wrong until then",
      ways.apart() / kDegree, turns.apart() / kDegree);
}

std::string oppositeAxisHint(const Matches& matches) {
  constexpr double kOpposite = -0.5;  // chosen, not tuned
  constexpr int kFewest = 30;         // frames
  constexpr double kNoise = 4;  // standard deviations of the correlation of noise, 1 / sqrt(n)
  constexpr std::array<const char*, 3> kAxes = {"x (pitch)", "y (yaw)", "z (roll)"};
  Eigen::Array3d products = Eigen::Array3d::Zero(), truths = products, estimates = products;
  int count = 0;
  for (std::size_t i = 1; i < matches.size(); ++i) {
    if (!isTrackedStep(matches, i)) continue;
    const Eigen::Array3d truth = turnBetween(matches.truth[i - 1], matches.truth[i]);
    const Eigen::Array3d estimate = turnBetween(matches.estimate[i - 1], matches.estimate[i]);
    products += truth * estimate;
    truths += truth.square();
    estimates += estimate.square();
    ++count;
  }
  if (count < kFewest) return "";
  const double most = std::min(kOpposite, -kNoise / std::sqrt(static_cast<double>(count)));
  for (int axis = 0; axis < 3; ++axis) {
    const double scale = std::sqrt(truths[axis] * estimates[axis]);
    if (!(products[axis] < most * scale)) continue;
    return fmt::format(
        "the truth turns the other way than the estimate about the camera's axis {} (a correlation "
        "of {:.2f} from frame to frame): does an axis or an angle of one of the two have the wrong "
        "sign? Rotation errors and drift are wrong if so",
        kAxes[static_cast<std::size_t>(axis)], products[axis] / scale);
  }
  return "";
}

}  // namespace tolman::evaluation
