// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/pose_reading.hpp"

#include <algorithm>
#include <functional>
#include <numbers>

#include "evaluation/turns.hpp"

namespace tolman::evaluation {
namespace {

// Chosen with KITTI 00 in view, where the three readings of the truth have 1.00, 0.08 and 0.17.
constexpr double kScattered = 0.5;
constexpr double kOneDirection = 0.95;
constexpr std::size_t kFewest = 30;  // steps

using Pose = Eigen::Isometry3d;
/// The motion from one pose to the next, in the axes of the camera.
using Step = std::function<Eigen::Vector3d(const Pose& from, const Pose& to)>;

Eigen::Vector3d asRead(const Pose& from, const Pose& to) {
  return from.linear().transpose() * (to.translation() - from.translation());
}

Eigen::Vector3d invertedStep(const Pose& from, const Pose& to) {
  return asRead(from.inverse(), to.inverse());
}

Eigen::Vector3d transposed(const Pose& from, const Pose& to) {
  return from.linear() * (to.translation() - from.translation());
}

Eigen::Vector3d chained(const Pose&, const Pose& to) { return to.translation(); }

struct Course {
  double length = 0;  ///< of all steps
  /// Length of the mean of the directions of the steps that are not short: 1 if they are the same,
  /// 0 if they are in all directions or too few.
  double concentration = 0;
};

Course courseOf(const Matches& matches, const Trajectory& poses, const Step& step) {
  Course course;
  std::vector<Eigen::Vector3d> steps;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!isTrackedStep(matches, i)) continue;
    steps.push_back(step(poses[i - 1].T_world_camera, poses[i].T_world_camera));
    course.length += steps.back().norm();
  }
  if (steps.size() < kFewest) return course;
  constexpr double kShort = 0.2;  // of the mean length: there noise gives the direction
  const double shortest = kShort * course.length / static_cast<double>(steps.size());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (const Eigen::Vector3d& each : steps) {
    if (each.norm() <= shortest) continue;
    sum += each.normalized();
    ++count;
  }
  if (count >= kFewest) course.concentration = sum.norm() / static_cast<double>(count);
  return course;
}

/// Whether most steps go on in the direction of the step before, as those of a path do, also of one
/// that is driven to and fro. Differences between motions are mostly noise.
bool goesOn(const Trajectory& poses) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 2; i < poses.size(); ++i) {
    const auto at = [&](std::size_t k) { return poses[k].T_world_camera.translation(); };
    const Eigen::Vector3d before = at(i - 1) - at(i - 2);
    const Eigen::Vector3d after = at(i) - at(i - 1);
    if (before.isZero(0) || after.isZero(0)) continue;
    sum += before.normalized().dot(after.normalized());
    ++count;
  }
  constexpr double kMostly = 0.7;  // chosen, not tuned; judged on motions of KITTI 00 to 07
  return sum > kMostly * static_cast<double>(count);
}

/// Whether all poses are turned by little, as motions from frame to frame are.
bool turnLittle(const Trajectory& poses) {
  constexpr double kLargest = 20 * std::numbers::pi / 180;
  return std::ranges::all_of(poses, [](const TrajectoryPose& pose) {
    return Eigen::AngleAxisd(pose.T_world_camera.linear()).angle() < kLargest;
  });
}

}  // namespace

std::string poseReadingHint(const Matches& matches) {
  const auto both = [&](const auto& holds) {
    return holds(matches.truth) && holds(matches.estimate);
  };
  const bool is_scattered = both([&](const Trajectory& poses) {
    const double given = courseOf(matches, poses, asRead).concentration;
    return given > 0 && given < kScattered;
  });
  if (!is_scattered) return "";
  constexpr const char* kRemedy = "? Errors are those of the path only if they are camera to world";
  // Turns at a distance from the origin make a path of invertedStep poses longer, never shorter.
  const bool are_inverse = both([&](const Trajectory& poses) {
    const Course course = courseOf(matches, poses, invertedStep);
    return course.concentration > kOneDirection &&
           course.length < courseOf(matches, poses, asRead).length;
  });
  if (are_inverse) {
    return std::string(
               "both trajectories move in all directions of their camera, but in one if "
               "every pose is invertedStep: are both world to camera") +
           kRemedy;
  }
  const bool are_transposed = both([&](const Trajectory& poses) {
    return courseOf(matches, poses, transposed).concentration > kOneDirection;
  });
  if (are_transposed) {
    return "both trajectories move in all directions of their camera, but in one if every rotation "
           "is transposed: are their positions of the camera, and their rotations from world to "
           "camera? Drift and rotation errors are wrong if so";
  }
  const bool are_motions = both([&](const Trajectory& poses) {
    return turnLittle(poses) && courseOf(matches, poses, chained).concentration > kOneDirection;
  });
  if (!are_motions || both(goesOn)) return "";
  return std::string(
             "both trajectories move in all directions of their camera, but in one if "
             "poses are motions from frame to frame: are they") +
         kRemedy;
}

}  // namespace tolman::evaluation
