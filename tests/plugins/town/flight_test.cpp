// SPDX-License-Identifier: BSD-3-Clause
// Cameras that are not level: mounted at an angle, or flown.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "support/context.hpp"
#include "support/data.hpp"
#include "town_source.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::test::TemporaryFolder;
using tolman::test::TestContext;

namespace {

std::vector<Frame> framesOf(ParameterValues values, CameraRig& rig, int count) {
  values.try_emplace("scale", 0.2);
  values.try_emplace("depth", true);
  TestContext context(values);
  TownSource source;
  const Status status = source.configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  rig = info.rig;
  std::vector<Frame> frames(static_cast<std::size_t>(count));
  for (Frame& frame : frames) REQUIRE(source.next(frame).isOk());
  return frames;
}

double depthAt(const Frame& frame, int row, int column) {
  const NamedArray& depth = frame.sensors.at(0);
  return static_cast<double>(depth.values[static_cast<std::size_t>(row * depth.shape[1] + column)]);
}

/// Share of the points of one frame that the other sees at the same place, if it sees there at all.
double agreement(const Frame& from, const Frame& to, const Eigen::Isometry3d& T_to_from,
                 const CameraRig& rig) {
  const Pinhole& k = rig.pinhole;
  int seen = 0;
  int equal = 0;
  for (int row = 0; row < rig.height; ++row) {
    for (int column = 0; column < rig.width; ++column) {
      const double depth = depthAt(from, row, column);
      if (depth <= 0 || depth > 40) continue;
      const Eigen::Vector3d point =
          T_to_from * (depth * Eigen::Vector3d((column - k.cx) / k.fx, (row - k.cy) / k.fy, 1));
      if (point.z() < 1) continue;
      const long u = std::lround(k.fx * point.x() / point.z() + k.cx);
      const long v = std::lround(k.fy * point.y() / point.z() + k.cy);
      if (u < 0 || u >= rig.width || v < 0 || v >= rig.height) continue;
      ++seen;
      const double there = depthAt(to, static_cast<int>(v), static_cast<int>(u));
      if (std::abs(there - point.z()) < 0.05 * point.z()) ++equal;
    }
  }
  CHECK(seen > 1000);
  return static_cast<double>(equal) / seen;
}

/// A way over level ground that rises by 4 m, pitching and rolling, as a KITTI pose file.
std::vector<Eigen::Isometry3d> writeFlight(const std::filesystem::path& file, double rise) {
  std::ofstream stream(file);
  stream.precision(17);
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 60; ++i) {
    Vector6d turn = Vector6d::Zero();
    turn[3] = 0.3 * std::sin(0.3 * i);
    turn[5] = 0.2 * std::sin(0.2 * i);
    poses.push_back(expSe3(turn));
    poses.back().translation() = Eigen::Vector3d(0, -rise * i / 60.0, i);
    const Eigen::Isometry3d& T = poses.back();
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 4; ++c) stream << T.matrix()(r, c) << (r * c == 6 ? '\n' : ' ');
    }
  }
  return poses;
}

}  // namespace

TEST_CASE("a camera mounted at an angle sees the same places, in its own axes") {
  CameraRig rig;
  const Frame level = framesOf({}, rig, 1)[0];
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  Vector6d up = Vector6d::Zero();
  up[3] = radians(-8);
  Vector6d right = Vector6d::Zero();
  right[5] = radians(20);
  const Eigen::Isometry3d T_level_tilted = expSe3(up) * expSe3(right);
  const auto frames = framesOf({{"camera_pitch", -8.0}, {"camera_roll", 20.0}}, rig, 2);
  CHECK(agreement(frames[0], level, T_level_tilted, rig) > 0.9);
  CHECK(agreement(level, frames[0], T_level_tilted.inverse(), rig) > 0.9);
  // Truth is that of the camera: it moves along the road, which is not its own z axis.
  const Eigen::Isometry3d moved =
      T_level_tilted * frames[1].T_world_camera_truth * T_level_tilted.inverse();
  const auto straight = framesOf({}, rig, 2);
  CHECK(moved.isApprox(straight[1].T_world_camera_truth, 1e-9));
}

TEST_CASE("a flight has the poses of its file over streets on level ground") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "flight.txt";
  const auto poses = writeFlight(file, 4);
  CameraRig rig;
  const ParameterValues values = {{"route", file.string()}, {"flight", true}};
  const auto frames = framesOf(values, rig, 45);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    CHECK(frames[i].T_world_camera_truth.isApprox(poses[0].inverse() * poses[i], 1e-6));
  }
  const Eigen::Isometry3d T_to_from =
      frames[21].T_world_camera_truth.inverse() * frames[20].T_world_camera_truth;
  CHECK(agreement(frames[20], frames[21], T_to_from, rig) > 0.8);
  // The ground right below is where the height says.
  const Frame& high = frames[30];
  const Eigen::Isometry3d& T = high.T_world_camera_truth;
  const int column = rig.width / 2;
  const int row = rig.height - 1;
  const Eigen::Vector3d seen = T * (depthAt(high, row, column) *
                                    Eigen::Vector3d((column - rig.pinhole.cx) / rig.pinhole.fx,
                                                    (row - rig.pinhole.cy) / rig.pinhole.fy, 1));
  CHECK(seen.y() == Approx(1.65).margin(0.2));
}

TEST_CASE("a flight into the ground is refused") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "flight.txt";
  writeFlight(file, -2);
  TestContext context({{"route", file.string()}, {"flight", true}});
  TownSource source;
  const Status status = source.configure(context);
  CHECK(status.message().find("m above the ground; give a larger camera_height") !=
        std::string::npos);
}
