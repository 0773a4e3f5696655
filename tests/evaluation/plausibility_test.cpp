// SPDX-License-Identifier: BSD-3-Clause
// Trajectories that are read wrongly or broken, and honest ones.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "evaluation/paths.hpp"
#include "evaluation/score.hpp"
#include "evaluation/step_series.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::size_t kHalf = 200;

using Change = std::function<Eigen::Isometry3d(const Eigen::Isometry3d&)>;

/// A car through bends, over bumps and hills, 1 m a frame, with a stop; `noise` m and a tenth of it
/// in rad at each step, so that it drifts.
Trajectory drive(double noise = 0, std::uint64_t seed = 8) {
  RandomStream random(seed);
  Trajectory path = test::straightPath(2 * kHalf);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << 30, 2, 10;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto t = static_cast<double>(i);
    Vector6d twist;
    twist << 0, 0, 1, 0.4 * kDegree * std::sin(0.2 * t), 2 * kDegree * std::sin(0.02 * t),
        0.2 * kDegree * std::sin(0.5 * t);
    if (i >= 100 && i < 130) twist.setZero();
    for (int k = 0; k < 6; ++k) twist[k] += (k < 3 ? 1 : 0.1) * noise * random.normal();
    T = normalised(T * expSe3(twist));
    path[i].T_world_camera = T;
  }
  return path;
}

Trajectory changed(Trajectory path, const Change& change) {
  for (TrajectoryPose& pose : path) pose.T_world_camera = change(pose.T_world_camera);
  return path;
}

Eigen::Isometry3d inverse(const Eigen::Isometry3d& T) { return T.inverse(); }

Eigen::Isometry3d withRotation(const Eigen::Isometry3d& T, const Eigen::Matrix3d& R) {
  Eigen::Isometry3d other = T;
  other.linear() = R;
  return other;
}

Eigen::Isometry3d transposed(const Eigen::Isometry3d& T) {
  return withRotation(T, T.linear().transpose());
}

/// x y z w, read from a file that has w x y z.
Eigen::Isometry3d scrambled(const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  return withRotation(T, Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix());
}

Change bodyAt(const Eigen::Vector3d& arm, double degrees, const Eigen::Vector3d& axis) {
  Eigen::Isometry3d body(Eigen::AngleAxisd(degrees * kDegree, axis.normalized()));
  body.translation() = arm;
  return [=](const Eigen::Isometry3d& T) { return T * body; };
}

Change mirrored(int axis, bool with_rotation) {
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(axis, axis) = -1;
  return [=](const Eigen::Isometry3d& T) {
    Eigen::Isometry3d other = T;
    other.translation() = mirror * T.translation();
    if (with_rotation) other.linear() = mirror * T.linear() * mirror;
    return other;
  };
}

Trajectory reversed(const Trajectory& path) {
  Trajectory other = path;
  for (std::size_t i = 0; i < path.size(); ++i) {
    other[i].T_world_camera = path[path.size() - 1 - i].T_world_camera;
  }
  return other;
}

Trajectory late(Trajectory path, std::int64_t ns) {
  for (TrajectoryPose& pose : path) pose.stamp_ns += ns;
  return path;
}

Trajectory withoutStamps(Trajectory path) {
  for (TrajectoryPose& pose : path) pose.stamp_ns = 0;
  return path;
}

std::string doubtsOf(const Trajectory& truth, const Trajectory& estimate,
                     Alignment alignment = Alignment::Se3) {
  return doubtText(doubts(truth, estimate, alignment));
}

/// Held from pose `first` to `last`, with noise.
Trajectory held(Trajectory path, std::size_t first, std::size_t last, double noise_m = 0) {
  RandomStream random(5);
  for (std::size_t i = first; i <= last; ++i) {
    path[i].T_world_camera = path[first].T_world_camera;
    path[i].T_world_camera.translation() +=
        noise_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  }
  return path;
}

/// The half from pose kHalf on, turned about that pose, scaled and moved.
Trajectory withHalf(Trajectory path, double degrees, double scale, double metres = 0) {
  const Eigen::Isometry3d T = path[kHalf].T_world_camera;
  Eigen::Isometry3d turn(Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitY()));
  turn.translation().x() = metres;
  for (std::size_t i = kHalf; i < path.size(); ++i) {
    Eigen::Isometry3d motion = T.inverse() * path[i].T_world_camera;
    motion.translation() *= scale;
    path[i].T_world_camera = T * turn * motion;
  }
  return path;
}

}  // namespace

TEST_CASE("a truth or an estimate that is read wrongly is named, with every alignment") {
  struct Case {
    const char* expected;
    Change change;
  };
  const std::vector<Case> cases = {
      {"poses are world to camera (", inverse},
      {"rotations are world to camera (transposed)", transposed},
      {"quaternions are in the order w x y z", scrambled},
      {"positions have the wrong sign in x", mirrored(0, false)},
      {"positions have the wrong sign in z", mirrored(2, false)},
  };
  const bool is_truth = GENERATE(true, false);
  for (const Case& each : cases) {
    CAPTURE(each.expected, is_truth);
    const Trajectory good = drive(0.01);
    const Trajectory bad = changed(drive(), each.change);
    const std::string which = is_truth ? "if the true " : "if the estimated ";
    for (const Alignment alignment : {Alignment::None, Alignment::Se3, Alignment::Sim3}) {
      CHECK_THAT(is_truth ? doubtsOf(bad, good, alignment) : doubtsOf(good, bad, alignment),
                 Catch::Contains(which + each.expected));
    }
  }
}

TEST_CASE("a truth of another body, in other units, order or time is named with the values") {
  const Eigen::Vector3d diagonal(1, -1, 1);
  const auto named = [](const Trajectory& truth) { return doubtsOf(truth, drive(0.01)); };
  CHECK_THAT(named(changed(drive(), bodyAt({0, 0, 0}, 120, diagonal))),
             Catch::Contains("of a body whose axes are turned by 120 degrees"));
  CHECK_THAT(named(changed(drive(), bodyAt({0, 0, 0}, 6, {1, 0, 0}))),
             Catch::Contains("of a body whose axes are turned by 6 degrees"));
  CHECK(named(changed(drive(), bodyAt({0, 0, 0}, 2, {1, 0, 0}))).empty());
  CHECK_THAT(named(changed(drive(), bodyAt({3, 0, -20}, 120, diagonal))),
             Catch::Contains("of a body at (3.") && Catch::Contains("-19.99 +- 0.02"));
  CHECK_THAT(doubtsOf(changed(drive(), bodyAt({0, 0, -5}, 0, {1, 0, 0})), drive(0.0001)),
             Catch::Contains("of a point at (-0.0") && Catch::Contains("-5.00"));
  for (const int axis : {0, 1, 2}) {
    CHECK_THAT(named(changed(drive(), mirrored(axis, true))),
               Catch::Contains("if one of the two has left-handed axes"));
  }
  CHECK_THAT(named(reversed(drive())), Catch::Contains("the true poses are in reverse order"));
  for (const double scale : {50.0, 2.0, 0.5, 0.3}) {
    const Trajectory scaled = test::moved(drive(), Eigen::Isometry3d::Identity(), scale);
    CHECK_THAT(named(scaled), Catch::Contains(fmt::format("multiplied by {:.2g}", scale)));
    CHECK_THAT(doubtsOf(scaled, drive(0.01), Alignment::Sim3), !Catch::Contains("multiplied"));
  }
  CHECK(named(test::moved(drive(), Eigen::Isometry3d::Identity(), 1.2)).empty());
  // Positions alone are no contradiction, and give no figures of rotation.
  const Trajectory alone =
      changed(drive(), [](const auto& T) { return withRotation(T, Eigen::Matrix3d::Identity()); });
  CHECK(named(alone).empty());
  const Scores scores = *score(alone, drive(0.01), Alignment::Se3).scores;
  CHECK(scores.ate_m.count == alone.size());
  CHECK(scores.vertical_m.count == 0);  // nothing says what is down
  CHECK(scores.kitti.segments + scores.rpe_frame.rotation_deg.count + scores.rotation_deg.count ==
        0);
}

TEST_CASE("clocks that differ are named, by stamps and by frames") {
  const std::string by_stamp =
      doubtText(doubts(drive(), late(drive(0.002), 130'000'000),
                       {Alignment::Se3, {}, {MatchRule::Nearest, 50'000'000}}));
  CHECK_THAT(by_stamp, Catch::Contains("the clock of the estimate is 0.129 s") &&
                           Catch::Contains("ahead of that of the truth"));
  Trajectory early = withoutStamps(drive());
  for (std::size_t i = 0; i + 3 < early.size(); ++i) {
    early[i].T_world_camera = early[i + 3].T_world_camera;
  }
  CHECK_THAT(doubtsOf(early, withoutStamps(drive(0.002))),
             Catch::Contains("the truth is given 3.0 frames early"));
}

TEST_CASE("a trajectory that stands is named") {
  const Trajectory path = test::straightPath(60);
  CHECK_THAT(doubtsOf(test::straightPath(60, 0), path),
             Catch::StartsWith("the truth stands still: the figures say nothing"));
  CHECK(doubtsOf(path, test::straightPath(60, 0)) == "the estimate does not move");
  for (const double noise_m : {0.0, 1e-3, 0.02}) {
    CAPTURE(noise_m);
    CHECK_THAT(doubtsOf(held(drive(), 300, 399, noise_m), drive(0.01)),
               Catch::StartsWith("the truth stands still from frame 300 to "));
    CHECK_THAT(doubtsOf(held(drive(), 250, 265, noise_m), drive(0.01)),
               Catch::Contains("the truth stands still from frame 250 to ") ||
                   Catch::Contains("the truth jumps"));
    CHECK_THAT(doubtsOf(drive(), held(drive(0.01), 250, 399, noise_m)),
               Catch::StartsWith("the estimate stands still from frame 250 to "));
  }
  Trajectory lost = held(drive(0.01), 250, 399);  // it says so
  for (std::size_t i = 250; i < lost.size(); ++i) lost[i].tracked = false;
  CHECK(doubtsOf(drive(), lost).empty());
  Trajectory rate = drive();  // every true pose is given for five frames
  for (std::size_t i = 0; i < rate.size(); ++i) {
    rate[i].T_world_camera = rate[i - i % 5].T_world_camera;
  }
  CHECK_FALSE(doubtsOf(rate, drive(0.01)).empty());
}

TEST_CASE("jumps, restarts and changes of units are named with the frame") {
  const Trajectory estimate = drive(0.01);
  CHECK_THAT(doubtsOf(withHalf(drive(), 0, 1, 8), estimate),
             Catch::StartsWith("from frame 199 to 200 the truth moves 8.0") &&
                 Catch::Contains("the truth jumps"));
  CHECK(doubtsOf(drive(), withHalf(estimate, 0, 1, 8)).empty());  // an error of the estimate
  for (const double degrees : {-170.0, -20.0, 45.0}) {
    CHECK_THAT(doubtsOf(withHalf(drive(), degrees, 1), estimate),
               Catch::StartsWith("from frame 199 to 200") && Catch::Contains("the truth jumps"));
  }
  CHECK(doubtsOf(drive(), withHalf(estimate, 45, 1)).empty());
  for (const double scale : {0.3048, 0.6, 3.28}) {
    CHECK_THAT(doubtsOf(withHalf(drive(), 0, scale), estimate, Alignment::Sim3),
               Catch::Contains("does the truth change its unit"));
  }
  CHECK(doubtsOf(withHalf(drive(), 0, 1.2), estimate).empty());
  Trajectory restarted = estimate;
  for (std::size_t i = kHalf; i < restarted.size(); ++i) {
    restarted[i].T_world_camera = restarted[0].T_world_camera *
                                  estimate[kHalf].T_world_camera.inverse() *
                                  estimate[i].T_world_camera;
  }
  CHECK_THAT(doubtsOf(drive(), restarted),
             Catch::StartsWith("from frame 199 to 200") &&
                 Catch::Contains("the estimate starts again at its origin"));
}

TEST_CASE("sessions whose truths are in frames of their own are named") {
  const auto inSessions = [](Trajectory path) {
    for (std::size_t i = kHalf; i < path.size(); ++i) path[i].session = 1;
    return path;
  };
  Trajectory own = inSessions(drive());
  const Eigen::Isometry3d first = own[kHalf].T_world_camera;
  for (std::size_t i = kHalf; i < own.size(); ++i) {
    own[i].T_world_camera = first.inverse() * own[i].T_world_camera;
  }
  const auto alignment = GENERATE(Alignment::None, Alignment::Se3, Alignment::Sim3);
  CHECK_THAT(doubtsOf(own, inSessions(drive(0.02)), alignment),
             Catch::Contains("the true poses of the sessions are not in one frame"));
  CHECK(doubtsOf(inSessions(drive()), inSessions(drive(0.02)), alignment).empty());
}

TEST_CASE("honest estimates, however poor, give no doubt") {
  for (const double noise : {0.0, 0.001, 0.01, 0.1, 0.3}) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      CAPTURE(noise, seed);
      CHECK(doubtsOf(drive(), drive(noise, seed)) == "");
      CHECK(doubtsOf(drive(), drive(noise, seed), Alignment::Sim3).empty());
    }
  }
  RandomStream random(4);
  const Trajectory one = test::wanderingPath(300, random);
  CHECK(doubtsOf(one, one).empty());
  CHECK(doubtsOf(one, test::wanderingPath(300, random)).empty());
  const Trajectory elsewhere = test::moved(drive(), test::randomPose(random));
  CHECK(doubtsOf(elsewhere, drive(0.01)).empty());
  for (const std::int64_t poses : {1, 2, 5, 9, 60}) {
    CHECK(doubtsOf(test::straightPath(poses), test::straightPath(poses)).empty());
  }
}

TEST_CASE("a slow robot with noise above its steps is honest") {
  RandomStream random(3);
  Trajectory truth;  // 3 mm a frame, round a bend
  for (int i = 0; i < 900; ++i) {
    const double t = 0.002 * i;
    Eigen::Isometry3d T(Eigen::AngleAxisd(t, Eigen::Vector3d::UnitY()));
    T.translation() << 1.5 * (1 - std::cos(t)), 0, 1.5 * std::sin(t);
    truth.push_back({i, 33'000'000LL * i, T});
  }
  Trajectory noisy = truth;
  for (TrajectoryPose& pose : noisy) {
    for (double& value : pose.T_world_camera.translation()) value += 0.005 * random.normal();
  }
  CHECK(doubtsOf(truth, noisy).empty());
  CHECK(doubtsOf(noisy, truth).empty());
  CHECK_FALSE(doubtsOf(truth, changed(noisy, scrambled)).empty());
}
