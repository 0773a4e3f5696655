// SPDX-License-Identifier: BSD-3-Clause
// Maps in space: loops over hills, separate storeys, any orientation of the first camera, and when
// `auto` uses the plane.
#include <cmath>
#include <tolman/context.hpp>

#include "map_fixture.hpp"

namespace tolman::experience_map {
namespace {

/// A lap of 40 steps of 2.5 m over a hill and back to its begin, camera level with the road.
std::vector<Eigen::Isometry3d> hillLaps(int laps, double climb_per_lap) {
  std::vector<Eigen::Isometry3d> truth;
  for (int k = 0; k <= 40 * laps; ++k) {
    const double angle = 2 * std::numbers::pi * k / 40;
    const double height = 3 * (1 - std::cos(angle)) + climb_per_lap * k / 40;
    Eigen::Isometry3d T = fromPlanar({16 * std::sin(angle), 16 - 16 * std::cos(angle), angle});
    T.translation().y() = -height;
    const double slope = std::atan2(3 * std::sin(angle) + climb_per_lap / 2 / std::numbers::pi, 16);
    T.linear() = T.linear() * expSo3({slope, 0, 0});
    truth.push_back(T);
  }
  const Eigen::Isometry3d start = truth.front();
  for (Eigen::Isometry3d& T : truth) T = start.inverse() * T;
  return truth;
}

struct Heights {
  double odometry = 0;  ///< rmse along the vertical of the first camera, m
  double map = 0;
  double horizontal_odometry = 0;
  double horizontal_map = 0;
};

/// Drives with noise and a drift of height; from the second lap on each fourth frame closes a loop
/// to the place of the first lap if `closes`.
Heights drive(const std::vector<Eigen::Isometry3d>& truth, Fixture& fixture, bool closes,
              std::uint64_t seed = 5) {
  RandomStream random(seed);
  fixture.covariance = isotropic(0.02, 0.002);
  std::vector<Eigen::Isometry3d> odometry = {Eigen::Isometry3d::Identity()};
  fixture.create(odometry[0]);
  for (std::size_t k = 1; k < truth.size(); ++k) {
    Vector6d noise;
    for (int i = 0; i < 6; ++i) noise[i] = (i < 3 ? 0.02 : 0.002) * random.normal();
    noise[1] += 0.02;  // sinks by 0.8 % of the way
    const Eigen::Isometry3d step = truth[k - 1].inverse() * truth[k] * expSe3(noise);
    odometry.push_back(odometry.back() * step);
    if (k % 4 != 0) {
      fixture.stay(step);
    } else if (k < 40 || !closes) {
      fixture.create(step);
    } else {
      const auto place = static_cast<std::int64_t>(k % 40 / 4);
      const Eigen::Isometry3d& there = truth[static_cast<std::size_t>(4 * place)];
      fixture.closeMeasured(step, place, there.inverse() * truth[k], 0.05);
    }
  }
  REQUIRE(fixture.map.finish({}).isOk());
  Heights rmse;
  const auto share = 1.0 / static_cast<double>(truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const auto miss = [&](const Eigen::Isometry3d& T) -> Eigen::Vector3d {
      return T.translation() - truth[k].translation();
    };
    const Eigen::Vector3d reckoned = miss(odometry[k]);
    const Eigen::Vector3d mapped = miss(fixture.poseOf(static_cast<std::int64_t>(k)));
    rmse.odometry += share * reckoned.y() * reckoned.y();
    rmse.map += share * mapped.y() * mapped.y();
    rmse.horizontal_odometry += share * (reckoned.squaredNorm() - reckoned.y() * reckoned.y());
    rmse.horizontal_map += share * (mapped.squaredNorm() - mapped.y() * mapped.y());
  }
  for (double* value :
       {&rmse.odometry, &rmse.map, &rmse.horizontal_odometry, &rmse.horizontal_map}) {
    *value = std::sqrt(*value);
  }
  return rmse;
}

ParameterValues in(const char* geometry) { return {{"space", std::string(geometry)}}; }

}  // namespace

TEST_CASE("a hill that is driven again closes in height") {
  const auto truth = hillLaps(3, 0);
  Fixture spatial;
  const Heights in_space = drive(truth, spatial, true);
  CAPTURE(in_space.odometry, in_space.map, in_space.horizontal_map);
  CHECK(in_space.odometry > 1);
  CHECK(in_space.map < 0.3 * in_space.odometry);
  Fixture planar(in("plane"));
  const Heights in_plane = drive(truth, planar, true);
  CHECK(in_plane.map == Approx(in_plane.odometry).epsilon(0.01));
  CHECK(in_space.horizontal_map < 1.1 * in_plane.horizontal_map);
}

TEST_CASE("without loops the map is the odometry, in space as in the plane") {
  const auto truth = hillLaps(2, 0);
  for (const char* geometry : {"plane", "space"}) {
    Fixture fixture(in(geometry));
    const Heights rmse = drive(truth, fixture, false);
    CHECK(rmse.map == Approx(rmse.odometry).margin(1e-9));
  }
}

TEST_CASE("a ramp of 3 m a lap keeps its storeys, and false loops between them are rejected") {
  const auto truth = hillLaps(3, 3);
  Fixture fixture;
  const Heights rmse = drive(truth, fixture, true);  // right loops, with the storeys between
  CHECK(rmse.map < 0.5);
  Fixture lied_to;
  RandomStream random(8);
  lied_to.covariance = isotropic(0.02, 0.002);
  lied_to.create(Eigen::Isometry3d::Identity());
  std::size_t lies = 0;
  for (std::size_t k = 1; k < truth.size(); ++k) {
    const Eigen::Isometry3d step = truth[k - 1].inverse() * truth[k];
    const auto place = static_cast<std::int64_t>(k % 40 / 4);
    if (k % 4 != 0) {
      lied_to.stay(step);
    } else if (k < 40) {
      lied_to.create(step);
    } else if (k % 16 == 0) {  // the storey below looks the same
      lied_to.closeMeasured(step, place, Eigen::Isometry3d::Identity(), 0.05);
      ++lies;
    } else {
      const Eigen::Isometry3d& there = truth[static_cast<std::size_t>(4 * place)];
      lied_to.closeMeasured(step, place, there.inverse() * truth[k], 0.05);
    }
  }
  REQUIRE(lied_to.map.finish({}).isOk());
  CHECK(lied_to.graph().rejected.size() == lies);
  CHECK(distance(lied_to.poseOf(120), truth[120]) < 0.1);
}

TEST_CASE("a first camera that is tilted by 40 degrees changes nothing") {
  const auto truth = hillLaps(3, 0);
  Fixture level;
  const Heights upright = drive(truth, level, true);
  // The same drive, seen by a camera that is turned on the car.
  const Eigen::Isometry3d lean(expSo3({0.7, 0, 0}));
  std::vector<Eigen::Isometry3d> seen;
  for (const Eigen::Isometry3d& T : truth) seen.push_back(lean.inverse() * T * lean);
  Fixture tilted;
  const Heights turned = drive(seen, tilted, true);
  const auto total = [](const Heights& h) { return std::hypot(h.map, h.horizontal_map); };
  // Noise is drawn along the camera's axes, so the errors are alike and not the same.
  CHECK(total(turned) < 1.5 * total(upright));
  Fixture planar(in("plane"));
  CHECK(total(drive(seen, planar, true)) > 2 * total(turned));
}

TEST_CASE(
    "the same motions in the axes of a camera that is tilted by 40 degrees make the same map") {
  const auto truth = hillLaps(3, 0);
  const auto mapOf = [&](const Eigen::Isometry3d& lean) {
    RandomStream random(5);
    Fixture fixture({{"recalibrate", false}});  // steady errors are along the camera's axes
    fixture.covariance = isotropic(0.02, 0.002);
    fixture.create(Eigen::Isometry3d::Identity());
    const auto in = [&](const Eigen::Isometry3d& motion) { return lean.inverse() * motion * lean; };
    for (std::size_t k = 1; k < truth.size(); ++k) {
      Vector6d noise;
      for (int i = 0; i < 6; ++i) noise[i] = (i < 3 ? 0.02 : 0.002) * random.normal();
      noise[1] += 0.02;
      const Eigen::Isometry3d step = in(truth[k - 1].inverse() * truth[k] * expSe3(noise));
      const auto place = static_cast<std::int64_t>(k % 40 / 4);
      const Eigen::Isometry3d& there = truth[static_cast<std::size_t>(4 * place)];
      if (k % 4 != 0) {
        fixture.stay(step);
      } else if (k < 40) {
        fixture.create(step);
      } else {
        fixture.closeMeasured(step, place, in(there.inverse() * truth[k]), 0.05);
      }
    }
    REQUIRE(fixture.map.finish({}).isOk());
    std::vector<Eigen::Isometry3d> poses;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      poses.push_back(lean * fixture.poseOf(static_cast<std::int64_t>(k)) * lean.inverse());
    }
    return poses;
  };
  const auto upright = mapOf(Eigen::Isometry3d::Identity());
  const auto tilted = mapOf(Eigen::Isometry3d(expSo3({0.7, 0, 0.2})));
  double size = 0;
  double apart = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    size = std::max(size, upright[k].translation().norm());
    apart = std::max(apart, distance(upright[k], tilted[k]));
  }
  CHECK(apart < 1e-4 * size);
}

TEST_CASE("auto stays in the plane for planar motion, assumed loops, and unknown scale") {
  const auto height = [](Fixture& f, bool measured, bool metric, double climb) {
    const auto along = [&](double forward) {
      Eigen::Isometry3d T = step(forward);
      T.translation().y() = climb;
      return T;
    };
    f.create(Eigen::Isometry3d::Identity());
    for (int k = 1; k <= 20; ++k) {
      Motion motion = f.motion(along(k <= 10 ? 1 : -1));
      motion.scale_known = metric;
      Decision decision = f.decision(Action::Stay, 0);
      if (k == 20) {
        decision = f.decision(Action::CloseLoop, 0);
        decision.has_relative_pose = measured;
        decision.covariance = isotropic(0.01, 0.01);
      }
      if (k == 10) decision = f.decision(Action::CreateExperience, 1);
      if (k > 10 && k < 20) decision.experience = 1;
      f.feed(motion, decision);
    }
    f.created = 2;
    REQUIRE(f.map.finish({}).isOk());
    return f.poseOf(20).translation().y();
  };
  Fixture spatial;
  CHECK(std::abs(height(spatial, true, true, 0.02)) < 0.2);
  Fixture mono;
  CHECK(height(mono, true, false, 0.02) == Approx(0.4));
  Fixture assumed;
  CHECK(height(assumed, false, true, 0.02) == Approx(0.4));
  Fixture planar;
  CHECK(height(planar, true, true, 0) == Approx(0).margin(1e-12));
}

TEST_CASE("a map in space is saved and goes on as it was") {
  const auto truth = hillLaps(2, 0);
  Fixture whole;
  (void)drive(truth, whole, true);
  std::stringstream stream;
  REQUIRE(whole.map.save(stream).isOk());
  Fixture loaded;
  REQUIRE(loaded.map.load(stream).isOk());
  for (std::int64_t k = 0; k < whole.frame; ++k) {
    REQUIRE((loaded.poseOf(k).matrix() - whole.poseOf(k).matrix()).norm() < 1e-12);
  }
}

}  // namespace tolman::experience_map
