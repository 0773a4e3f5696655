// SPDX-License-Identifier: BSD-3-Clause
// Four matches at once against one after the other, with project().
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "pnp.hpp"
#include "support/street_scene.hpp"

namespace tolman::feature_stereo {
namespace {

constexpr double kLimit = 11.34;
const PixelNoise kNoise;

Vector6d randomTwist(RandomStream& random, double scale) {
  Vector6d twist;
  for (double& value : twist) value = scale * random.normal();
  return twist;
}

/// Some without a disparity, some behind the camera, some far off.
std::vector<PointMatch> someMatches(std::size_t count, const Eigen::Isometry3d& T) {
  RandomStream random(count);
  std::vector<PointMatch> matches;
  for (std::size_t i = 0; i < count; ++i) {
    PointMatch match;
    match.point.T_world_reference = expSe3(randomTwist(random, 0.05));
    match.point.coordinates << random.uniform(-0.6, 0.6), random.uniform(-0.3, 0.3),
        1 / random.uniform(3, 60);
    if (i % 11 == 3)
      match.point.T_world_reference = T * expSe3((Vector6d() << 0, 0, -50, 0, 0, 0).finished());
    const Eigen::Matrix3d root =
        0.01 * Eigen::Matrix3d::NullaryExpr([&] { return random.normal(); });
    match.point_covariance = root * root.transpose();
    match.pixel << 200, 100, 7;
    const auto seen = project(test::streetRig(), T, match.point);
    if (seen)
      match.pixel = *seen + Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    if (i % 13 == 5) match.pixel.x() += 300;
    match.has_disparity = i % 3 != 1;
    matches.push_back(match);
  }
  return matches;
}

struct Single {
  StereoPixel error;
  Eigen::Matrix3d weight;
  ProjectionJacobians J;
  double distance = 1e30;
};

Single evaluate(const PointMatch& match, const Eigen::Isometry3d& T) {
  Single one;
  const auto predicted = project(test::streetRig(), T, match.point, &one.J);
  if (!predicted) return one;
  Eigen::Vector3d variances = kNoise.sigma(predicted->z()).cwiseAbs2();
  if (!match.has_disparity) variances.z() = 1e9;
  Eigen::Matrix3d covariance = variances.asDiagonal();
  covariance += one.J.point * match.point_covariance * one.J.point.transpose();
  one.weight = covariance.inverse();
  one.error = match.pixel - *predicted;
  if (!match.has_disparity) one.error.z() = 0;
  one.distance = one.error.dot(one.weight * one.error);
  return one;
}

}  // namespace

TEST_CASE("distances, cost and normal equations are those of single matches") {
  RandomStream random(4);
  const Eigen::Isometry3d T = expSe3(randomTwist(random, 0.1));
  for (const std::size_t count : {1, 4, 7, 90}) {
    const std::vector<PointMatch> matches = someMatches(count, T);
    PoseLanes lanes(test::streetRig(), matches, kNoise);
    lanes.weigh(T);
    const std::vector<double> distances = lanes.distances(T);
    REQUIRE(distances.size() == count);
    Matrix6d information = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
    double cost = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Single one = evaluate(matches[i], T);
      CHECK(distances[i] == Approx(one.distance).epsilon(1e-6));
      cost += std::min(kLimit, one.distance);
      if (one.distance > kLimit) continue;
      const double robust = 1 / (1 + one.distance / 5.7);
      information += robust * one.J.pose.transpose() * one.weight * one.J.pose;
      gradient += robust * one.J.pose.transpose() * one.weight * one.error;
    }
    Matrix6d found;
    Vector6d slope;
    lanes.linearise(T, kLimit, found, slope);
    CHECK(lanes.cost(T, kLimit) == Approx(cost).epsilon(1e-9));
    CHECK((found - information).norm() <= 1e-8 * information.norm());
    CHECK((slope - gradient).norm() <= 1e-8 * (1 + gradient.norm()));
  }
}

}  // namespace tolman::feature_stereo
