// SPDX-License-Identifier: BSD-3-Clause
// A map with a minimal host, and functions that give it frames.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "experience_map.hpp"
#include "support/context.hpp"

namespace tolman::experience_map {

/// A configured map. Frames count up by themselves, at 10 Hz.
struct Fixture {
  explicit Fixture(const ParameterValues& values = {}) : host(values) {
    REQUIRE(map.configure(host).isOk());
  }

  Motion motion(const Eigen::Isometry3d& T_previous_current) const {
    Motion m;
    m.frame = frame;
    m.stamp_ns = frame * 100'000'000;
    m.state = frame == 0 ? TrackingState::Initialising : TrackingState::Tracking;
    m.T_previous_current = T_previous_current;
    m.covariance = covariance;
    return m;
  }
  Decision decision(Action action, std::int64_t experience) const {
    Decision d;
    d.frame = frame;
    d.action = action;
    d.experience = experience;
    return d;
  }
  MapUpdate feed(const Motion& m, const Decision& d) {
    MapUpdate update;
    const Status status = map.update(m, d, update);
    INFO(status.message());
    REQUIRE(status.isOk());
    REQUIRE(firstInvalidField(update).empty());
    current = update.experience;
    ++frame;
    return update;
  }
  MapUpdate stay(const Eigen::Isometry3d& T) {
    return feed(motion(T), decision(Action::Stay, current));
  }
  MapUpdate create(const Eigen::Isometry3d& T) {
    return feed(motion(T), decision(Action::CreateExperience, created++));
  }
  MapUpdate close(const Eigen::Isometry3d& T, std::int64_t experience, double relative_yaw = 0) {
    Decision d = decision(Action::CloseLoop, experience);
    d.relative_yaw = relative_yaw;
    return feed(motion(T), d);
  }
  MapUpdate closeMeasured(const Eigen::Isometry3d& T, std::int64_t experience,
                          const Eigen::Isometry3d& T_experience_current, double sigma = 0.01) {
    Decision d = decision(Action::CloseLoop, experience);
    d.has_relative_pose = true;
    d.T_experience_current = T_experience_current;
    d.covariance = isotropic(sigma, sigma);
    return feed(motion(T), d);
  }

  Eigen::Isometry3d poseOf(std::int64_t k) const {
    Eigen::Isometry3d T;
    REQUIRE(map.poseOf(k, T).isOk());
    return T;
  }
  MapGraph graph() const {
    MapGraph g;
    REQUIRE(map.graph(g).isOk());
    return g;
  }

  test::TestContext host;
  ExperienceMap map;
  Matrix6d covariance = isotropic(0.01, 0.001);  ///< of every motion
  std::int64_t frame = 0;
  std::int64_t created = 0;
  std::int64_t current = -1;
};

/// The step of a car: `forward` m, then a turn to the left by `turn` rad.
inline Eigen::Isometry3d step(double forward, double turn = 0) {
  return fromPlanar({forward, 0, turn});
}

inline double distance(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

/// Largest difference of any number of the two poses.
inline double difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace tolman::experience_map
