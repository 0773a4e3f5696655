// SPDX-License-Identifier: BSD-3-Clause
// KITTI's drives with their true heights, odometry with a drift of height of up to 0.3 % of the
// path, and true revisits: the map in space corrects the height, the one in the plane cannot.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <tolman/context.hpp>

#include "map_fixture.hpp"
#include "support/data.hpp"

namespace tolman::experience_map {
namespace {

std::vector<Eigen::Isometry3d> readPoses(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<Eigen::Isometry3d> poses;
  for (Eigen::Matrix4d m = Eigen::Matrix4d::Identity(); stream >> m(0, 0);) {
    for (int i = 1; i < 12; ++i) stream >> m(i / 4, i % 4);
    poses.push_back(normalised(Eigen::Isometry3d(m)));
  }
  return poses;
}

Eigen::Isometry3d noise(RandomStream& random, double metres, double radians) {
  Vector6d twist;
  for (int i = 0; i < 6; ++i) twist[i] = (i < 3 ? metres : radians) * random.normal();
  return expSe3(twist);
}

struct Made {
  std::size_t frame = 0;
  double driven = 0;  ///< m
};

/// The first experience at the same place, seen in the same direction; at least 50 m of way before.
std::optional<std::size_t> revisited(const std::vector<Eigen::Isometry3d>& truth,
                                     const std::vector<Made>& made, const Made& now) {
  const Eigen::Isometry3d& here = truth[now.frame];
  for (std::size_t i = 0; i < made.size() && now.driven - made[i].driven > 50; ++i) {
    const Eigen::Isometry3d& there = truth[made[i].frame];
    const Eigen::Vector3d apart = there.translation() - here.translation();
    const double agrees = there.linear().col(2).dot(here.linear().col(2));
    if (std::hypot(apart.x(), apart.z()) < 3 && agrees > 0.9) return i;
  }
  return std::nullopt;
}

struct Rmse {
  double vertical = 0;
  double horizontal = 0;
};

struct Drive {
  Rmse odometry;
  Rmse map;
  int loops = 0;
};

void add(Rmse& sum, const Eigen::Isometry3d& pose, const Eigen::Isometry3d& truth) {
  const Eigen::Vector3d miss = pose.translation() - truth.translation();
  sum.vertical += miss.y() * miss.y();
  sum.horizontal += miss.x() * miss.x() + miss.z() * miss.z();
}

/// `sinking`: m per m driven.
Drive drive(const std::vector<Eigen::Isometry3d>& truth, const char* geometry, double sinking) {
  Fixture fixture({{"space", std::string(geometry)}});
  fixture.covariance = isotropic(0.01, 0.00005);
  RandomStream random(11);
  Drive result;
  std::vector<Eigen::Isometry3d> odometry = {Eigen::Isometry3d::Identity()};
  std::vector<Made> made = {{}};
  Made now;
  fixture.create(odometry[0]);
  for (std::size_t k = 1; k < truth.size(); ++k) {
    Eigen::Isometry3d step = truth[k - 1].inverse() * truth[k];
    const double metres = step.translation().norm();
    now = {k, now.driven + metres};
    step = step * noise(random, 0.01, 0.00005);
    step.translation().y() += sinking * metres;
    odometry.push_back(odometry.back() * step);
    const auto place = k % 5 == 0 ? revisited(truth, made, now) : std::nullopt;
    if (place) {
      const Eigen::Isometry3d seen = truth[made[*place].frame].inverse() * truth[k];
      fixture.closeMeasured(step, static_cast<std::int64_t>(*place),
                            seen * noise(random, 0.1, 0.01), 0.1);
      ++result.loops;
    } else if (now.driven - made.back().driven > 5) {
      made.push_back(now);
      fixture.create(step);
    } else {
      fixture.stay(step);
    }
  }
  REQUIRE(fixture.map.finish({}).isOk());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    add(result.odometry, odometry[k], truth[k]);
    add(result.map, fixture.poseOf(static_cast<std::int64_t>(k)), truth[k]);
  }
  const auto frames = static_cast<double>(truth.size());
  for (Rmse* sum : {&result.odometry, &result.map}) {
    *sum = {std::sqrt(sum->vertical / frames), std::sqrt(sum->horizontal / frames)};
  }
  return result;
}

}  // namespace

TEST_CASE("loops in space take a sinking odometry's height back on KITTI's hills", "[data]") {
  for (const char* name : {"00", "02", "05", "06", "07"}) {
    const auto file = test::dataOrSkip(std::string("kitti_poses/") + name + ".txt");
    if (!file) return;
    const std::vector<Eigen::Isometry3d> truth = readPoses(*file);
    REQUIRE(truth.size() > 1000);
    for (const double sinking : {0.003, -0.003, 0.001, 0.0}) {
      const Drive space = drive(truth, "auto", sinking);
      std::cout << "KITTI " << name << ", " << space.loops << " loops, sinks by " << sinking
                << ", RMSE vertical and horizontal: odometry " << space.odometry.vertical << " m, "
                << space.odometry.horizontal << " m; map " << space.map.vertical << " m, "
                << space.map.horizontal << " m\n";
      // Loops that are good to 0.1 m and 0.01 rad cannot mend an odometry that is as good.
      const bool sinks_much = std::abs(sinking) > 0.002;
      CHECK(space.map.vertical < std::max(space.odometry.vertical / 3, sinks_much ? 0.0 : 0.6));
      CHECK(space.map.horizontal < std::max(space.odometry.horizontal, 0.25));
    }
    const Drive plane = drive(truth, "plane", 0.003);
    CHECK(plane.map.vertical > 0.9 * plane.odometry.vertical);
  }
}

}  // namespace tolman::experience_map
