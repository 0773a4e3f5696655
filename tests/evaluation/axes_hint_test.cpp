// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/axes_hint.hpp"

#include <catch2/catch.hpp>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// A drive with turns: forward along z, about y.
Trajectory drive() {
  Trajectory path = test::straightPath(60);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (TrajectoryPose& pose : path) {
    pose.T_world_camera = T;
    T = T * Eigen::Translation3d(0, 0, 1) *
        Eigen::AngleAxisd(0.1 * std::sin(0.2 * static_cast<double>(pose.frame)),
                          Eigen::Vector3d::UnitY());
  }
  return path;
}

Trajectory withAxes(Trajectory path, const Eigen::Matrix3d& R_camera_body) {
  for (TrajectoryPose& pose : path) pose.T_world_camera.rotate(R_camera_body);
  return path;
}

}  // namespace

TEST_CASE("truth in axes of the vehicle's body, x forward and z up, is detected") {
  const Trajectory estimate = drive();
  Eigen::Matrix3d R_camera_body;
  R_camera_body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const std::string hint = axesHint(test::paired(withAxes(estimate, R_camera_body), estimate));
  CHECK(hint.starts_with("true and estimated motion point in directions 90 degrees apart"));
}

TEST_CASE("world-to-camera poses are detected; camera-to-world poses in any world give no hint") {
  RandomStream random(3);
  const Trajectory estimate = drive();
  Trajectory inverse = estimate;
  for (TrajectoryPose& pose : inverse) pose.T_world_camera = pose.T_world_camera.inverse();
  CHECK(axesHint(test::paired(inverse, estimate))
            .starts_with("the true poses, read as world to camera, agree with the estimate"));
  CHECK(axesHint(test::paired(test::moved(estimate, test::randomPose(random)), estimate)).empty());
}

TEST_CASE("true poses in reverse order: the hint names the order") {
  const auto reversed = [](const Trajectory& path) {
    Trajectory truth = path;
    for (std::size_t i = 0; i < path.size(); ++i) {
      truth[i].T_world_camera = path[path.size() - 1 - i].T_world_camera;
    }
    return truth;
  };
  const Trajectory straight = test::straightPath(60);
  const std::string either = axesHint(test::paired(reversed(straight), straight));
  CHECK(either.find("write camera-to-world poses, or") != std::string::npos);
  CHECK(either.find("in the order of the frames") != std::string::npos);
  Trajectory block = straight;  // around a block: not alike when inverted, as straight and round
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (TrajectoryPose& pose : block) {
    pose.T_world_camera = T;
    const double turn = pose.frame == 20 || pose.frame == 40 ? std::numbers::pi / 2 : 0;
    T = T * Eigen::Translation3d(0, 0, 1) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY());
  }
  const std::string order = axesHint(test::paired(reversed(block), block));
  CHECK(order.find("and in the order of the frames?") != std::string::npos);
  Trajectory inverse = block;
  for (TrajectoryPose& pose : inverse) pose.T_world_camera = pose.T_world_camera.inverse();
  const std::string inverted = axesHint(test::paired(inverse, block));
  CHECK(inverted.starts_with("the true poses, read as world to camera"));
  CHECK(inverted.find("order") == std::string::npos);
}

TEST_CASE("a poor estimate, few frames and standing still are no reason for a hint") {
  RandomStream random(4);
  const Trajectory truth = drive();
  CHECK(axesHint(test::paired(truth, test::wanderingPath(60, random))).empty());
  const Trajectory still = test::straightPath(60, 0);
  CHECK(axesHint(test::paired(still, truth)).empty());
  Trajectory few(truth.begin(), truth.begin() + 5);
  CHECK(
      axesHint(test::paired(
                   withAxes(few, Eigen::AngleAxisd(2, Eigen::Vector3d::UnitX()).toRotationMatrix()),
                   few))
          .empty());
}

TEST_CASE("wrong rotations with right positions are detected in either trajectory") {
  const Trajectory truth = drive();
  Trajectory scrambled = truth;
  for (TrajectoryPose& pose : scrambled) {
    const Eigen::Quaterniond q(pose.T_world_camera.linear());
    // x y z w, read from a file that has w x y z
    const Eigen::Quaterniond wrong(q.z(), q.w(), q.x(), q.y());
    pose.T_world_camera.linear() = wrong.normalized().toRotationMatrix();
  }
  CHECK(rotationHint(test::paired(truth, scrambled)).starts_with("the positions agree, but"));
  CHECK(rotationHint(test::paired(scrambled, truth)).starts_with("the positions agree, but"));
  CHECK(rotationHint(test::paired(truth, truth)).empty());
  RandomStream random(5);
  CHECK(rotationHint(test::paired(truth, test::wanderingPath(60, random))).empty());
}

TEST_CASE("noise of slow motion does not turn its directions, wrong rotations do") {
  RandomStream random(3);
  Trajectory truth;  // a robot at 3 mm a frame, round a bend
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
  CHECK(scoreTrajectory(truth, noisy, Alignment::Se3).warning.empty());
  CHECK(scoreTrajectory(noisy, truth, Alignment::Se3).warning.empty());
  for (TrajectoryPose& pose : noisy) {  // w x y z
    const Eigen::Quaterniond q(pose.T_world_camera.linear());
    pose.T_world_camera.linear() =
        Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix();
  }
  CHECK_FALSE(scoreTrajectory(truth, noisy, Alignment::Se3).warning.empty());
}

TEST_CASE("mirrored positions, which an alignment turns upside down, are detected") {
  const auto at = [](int i, double side) {  // along a road with a slight bend
    const double angle = 0.01 * i;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
    T.translation() << side * 100 * (1 - std::cos(angle)), 0, 100 * std::sin(angle);
    return T;
  };
  Trajectory truth;
  Trajectory turned;  // as the alignment turns the mirrored one: about the road
  const Eigen::Isometry3d about_road(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));
  for (int i = 0; i < 30; ++i) {
    truth.push_back({i, i, at(i, 1), true});
    turned.push_back({i, i, about_road * at(i, -1), true});
  }
  CHECK(rotationHint(test::paired(truth, turned)).starts_with("the positions agree only where"));
  CHECK(rotationHint(test::paired(truth, truth)).empty());
}

TEST_CASE("turns of the opposite sign are detected with every alignment") {
  const auto angle = [](int i) { return std::sin(0.1 * i); };
  const auto path = [&](double side, double turn) {  // signs of the positions and of the angles
    Trajectory poses;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 200; ++i) {
      T.linear() = Eigen::AngleAxisd(turn * angle(i), Eigen::Vector3d::UnitY()).toRotationMatrix();
      T.translation() += Eigen::Vector3d(side * std::sin(angle(i)), 0, std::cos(angle(i)));
      poses.push_back({i, 100'000'000LL * i, T, true});
    }
    return poses;
  };
  const Trajectory estimate = path(1, 1);
  for (const Alignment alignment : {Alignment::None, Alignment::Se2, Alignment::Se3}) {
    for (const Trajectory& truth : {path(-1, -1), path(1, -1)}) {
      CHECK_THAT(scoreTrajectory(truth, estimate, alignment).warning,
                 Catch::StartsWith("the truth turns the other way than the estimate"));
    }
    CHECK(scoreTrajectory(estimate, estimate, alignment).warning.empty());
  }
  RandomStream random(6);
  CHECK(turnHint(test::paired(estimate, test::wanderingPath(200, random))).empty());
  CHECK(turnHint(test::paired(test::straightPath(200), estimate)).empty());
  Trajectory lost = path(-1, -1);
  for (TrajectoryPose& pose : lost) pose.tracked = false;
  CHECK(turnHint(test::paired(estimate, lost)).empty());
}

TEST_CASE("a rotation about a nearly straight path gives no hint of wrong axes") {
  Trajectory truth = test::straightPath(12);
  Trajectory estimate = truth;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double along = static_cast<double>(i) - 5.5;
    truth[i].T_world_camera.translation().x() = 0.0003 * along * along;
    estimate[i].T_world_camera.translation().x() = -0.0003 * along * along;  // half a turn away
  }
  const TrajectoryMetrics metrics = scoreTrajectory(truth, estimate, Alignment::Se3);
  CHECK(metrics.warning.empty());
  CHECK(metrics.scores->ate_m.rmse < 1e-6);
  CHECK_THAT(metrics.scores->no_horizontal, Catch::Contains("how the estimate is turned about it"));
  for (std::size_t i = 0; i < truth.size();
       ++i) {  // a bend of half a metre is no error of odometry
    truth[i].T_world_camera.translation().x() *= 60;
    estimate[i].T_world_camera.translation().x() *= 60;
  }
  CHECK_THAT(scoreTrajectory(truth, estimate, Alignment::Se3).warning,
             Catch::Contains("against its own orientations"));
}

TEST_CASE("an estimate that is right but for its scale is told, one that is only poor is not") {
  const Trajectory truth = drive();
  const auto hint = [&](double factor, double noise) {
    RandomStream random(5);
    Trajectory estimate = truth;
    for (TrajectoryPose& pose : estimate) {
      Eigen::Vector3d moved = pose.T_world_camera.translation() * factor;
      for (double& x : moved) x += noise * random.normal();
      pose.T_world_camera.translation() = moved;
    }
    return scaleHint(test::paired(truth, estimate));
  };
  CHECK_THAT(hint(5, 0), Catch::StartsWith("the estimate is the true path but for its scale: "
                                           "multiplied by 0.2 it agrees within"));
  CHECK_THAT(hint(0.5, 0.01), Catch::Contains("multiplied by 2 it"));
  CHECK(hint(1.4, 0).empty());
  CHECK(hint(0.7, 0).empty());
  CHECK(hint(1, 0).empty());
  CHECK(hint(1, 100).empty());  // noise makes a path longer, but agrees at no scale
  CHECK(scaleHint(test::paired(truth, test::straightPath(60))).empty());
}

TEST_CASE("positions in millimetres are detected; a poor scale gives no hint") {
  const Trajectory estimate = drive();
  const auto scaled = [&](double factor) {
    Trajectory path = estimate;
    for (TrajectoryPose& pose : path) pose.T_world_camera.translation() *= factor;
    return test::paired(path, estimate);
  };
  CHECK(unitHint(scaled(1000)).starts_with("the true path is 1e+03 times as long"));
  CHECK(unitHint(scaled(0.01)).starts_with("the true path is 0.01 times as long"));
  CHECK(unitHint(scaled(0.001)).empty());  // 6 cm may be any distance
  CHECK(unitHint(scaled(1.4)).empty());
  CHECK(unitHint(scaled(0.3)).empty());  // noise makes a path longer
  CHECK(unitHint(scaled(2)).starts_with("the estimated path is only 0.5 times as long"));
  CHECK(unitHint(scaled(0)).empty());  // the robot stands
  Trajectory still = estimate;
  for (TrajectoryPose& pose : still) pose.T_world_camera.translation().setZero();
  CHECK(unitHint(test::paired(estimate, still)) == "the estimate does not move");
}

TEST_CASE("two paths in millimetres are detected by the speed that the stamps tell") {
  const auto scaled = [](double factor) {
    return test::moved(drive(), Eigen::Isometry3d::Identity(), factor);  // of 10 m/s
  };
  const std::string hint = speedHint(test::paired(scaled(1000), scaled(1000)));
  CHECK(hint.starts_with("by the stamps the true path is driven at 1e+04 m/s (median)"));
  CHECK(speedHint(test::paired(scaled(90), scaled(90))).empty());
  CHECK(scoreTrajectory(scaled(1000), scaled(1000), Alignment::Se3).warning == hint);
  CHECK(scoreTrajectory(scaled(1000), scaled(1000), Alignment::Sim3).warning == hint);
  CHECK(toJson(scoreTrajectory(scaled(1000), scaled(1000), Alignment::Se3))["warning"] == hint);
  CHECK(scoreTrajectory(scaled(1), scaled(1), Alignment::Se3).warning.empty());
  // Only one of the two has times, or none has.
  Trajectory untimed = scaled(1000);
  for (TrajectoryPose& pose : untimed) pose.stamp_ns = 0;
  CHECK(speedHint(test::paired(untimed, scaled(1000))) == hint);
  CHECK(speedHint(test::paired(untimed, untimed)).empty());
}

TEST_CASE("poses with x forward and z up are detected; camera poses and slopes give no hint") {
  Eigen::Matrix3d R_camera_body;
  R_camera_body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  Trajectory climbing = drive();
  for (TrajectoryPose& pose : climbing) {
    pose.T_world_camera.translation().y() -= 0.05 * pose.T_world_camera.translation().z();
  }
  CHECK(upHint(drive()).empty());
  CHECK(upHint(climbing).empty());
  CHECK(upHint(test::straightPath(60)).empty());
  CHECK(upHint({}).empty());
  const std::string hint = upHint(withAxes(climbing, R_camera_body));
  CHECK(hint.starts_with("the true poses move along their own x axis, and more along the y axis"));
  // Positions alone, without orientations.
  Trajectory positions = test::straightPath(60);
  for (TrajectoryPose& pose : positions) {
    const double x = pose.T_world_camera.translation().z();
    pose.T_world_camera.translation() = Eigen::Vector3d(x, 3 * std::sin(0.1 * x), 0);
  }
  CHECK_FALSE(upHint(positions).empty());
  CHECK(scoreTrajectory(positions, positions, Alignment::Se2).warning ==
        upHint(positions) + ", or use se3; se2 leaves y out");
  CHECK(scoreTrajectory(positions, positions, Alignment::Se3).warning.empty());
}

TEST_CASE("with z up errors are not divided by a wrong vertical direction") {
  Eigen::Matrix3d R_camera_body;
  R_camera_body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  Trajectory estimate = drive();
  for (std::size_t i = 0; i < estimate.size(); ++i) {  // errors to the right only
    estimate[i].T_world_camera.translation().x() += 0.2 * std::sin(0.7 * static_cast<double>(i));
  }
  const Trajectory truth = drive();
  const auto camera = scoreTrajectory(truth, estimate, Alignment::Se3);
  CHECK(camera.scores->horizontal_m.count > 0);
  CHECK(camera.scores->vertical_m.rmse < 0.2 * camera.scores->horizontal_m.rmse);
  const Trajectory body_truth = withAxes(truth, R_camera_body);
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3}) {
    const auto body = scoreTrajectory(body_truth, withAxes(estimate, R_camera_body), alignment);
    REQUIRE(body.scores);
    CHECK(body.scores->ate_m.count > 0);
    CHECK(body.scores->vertical_m.count == 0);
    CHECK(body.scores->horizontal_m.count == 0);
    CHECK(body.scores->no_vertical == upHint(body_truth));
    CHECK_FALSE(body.scores->no_vertical.empty());
  }
}
