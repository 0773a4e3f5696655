// SPDX-License-Identifier: BSD-3-Clause
// Covariance along chains of poses, against the definition and against sampling.
#include "uncertain_pose.hpp"

#include <catch2/catch.hpp>
#include <tolman/context.hpp>

namespace tolman::experience_map {
namespace {

Vector6d randomTwist(RandomStream& random, double scale) {
  Vector6d twist;
  for (double& value : twist) value = scale * random.normal();
  return twist;
}

UncertainPose randomPose(RandomStream& random) {
  Matrix6d root;
  for (double& value : root.reshaped()) value = 0.01 * random.normal();
  return {expSe3(randomTwist(random, 0.7)), root * root.transpose()};
}

/// Covariance of logSe3(estimate^-1 * sample) over draws of the two noises.
template <class Combine>
Matrix6d sampled(const UncertainPose& a, const UncertainPose& b, const Eigen::Isometry3d& estimate,
                 const Combine& combine) {
  RandomStream random(7);
  const Matrix6d root_a = a.covariance.llt().matrixL();
  const Matrix6d root_b = b.covariance.llt().matrixL();
  Matrix6d sum = Matrix6d::Zero();
  constexpr int kDraws = 20000;
  for (int k = 0; k < kDraws; ++k) {
    const Eigen::Isometry3d noisy_a = a.T * expSe3(root_a * randomTwist(random, 1));
    const Eigen::Isometry3d noisy_b = b.T * expSe3(root_b * randomTwist(random, 1));
    const Vector6d error = logSe3(estimate.inverse() * combine(noisy_a, noisy_b));
    sum += error * error.transpose();
  }
  return sum / kDraws;
}

}  // namespace

TEST_CASE("the adjoint moves a small motion from the right of a pose to its left") {
  RandomStream random(1);
  for (int k = 0; k < 20; ++k) {
    const Eigen::Isometry3d T = expSe3(randomTwist(random, 1));
    const Vector6d n = randomTwist(random, 0.3);
    const Eigen::Isometry3d left = expSe3(adjointSe3(T) * n) * T;
    CHECK((left.matrix() - (T * expSe3(n)).matrix()).norm() < 1e-12);
  }
}

TEST_CASE("composed and inverted covariance agrees with sampling") {
  RandomStream random(2);
  const UncertainPose a = randomPose(random);
  const UncertainPose b = randomPose(random);

  const UncertainPose chain = compose(a, b);
  const Matrix6d chain_sampled =
      sampled(a, b, chain.T, [](const auto& x, const auto& y) { return x * y; });
  CHECK((chain_sampled - chain.covariance).norm() < 0.04 * chain.covariance.norm());

  const UncertainPose back = inverse(a);
  const Matrix6d back_sampled =
      sampled(a, b, back.T, [](const auto& x, const auto&) { return x.inverse(); });
  CHECK((back_sampled - back.covariance).norm() < 0.04 * back.covariance.norm());
}

TEST_CASE("a yaw error at the start becomes a sideways error at the end of the lever") {
  UncertainPose turn;
  turn.covariance(4, 4) = 1e-4;  // 0.01 rad about y
  const UncertainPose straight{fromPlanar({100, 0, 0}), Matrix6d::Zero()};
  const Matrix6d covariance = compose(turn, straight).covariance;
  CHECK(std::sqrt(covariance(0, 0)) == Approx(1.0));  // 100 m * 0.01 rad
  CHECK(covariance(2, 2) == Approx(0).margin(1e-15));
}

TEST_CASE("planar covariance is the linearised planar pose of a leaning camera") {
  RandomStream random(3);
  const Eigen::Matrix3d R = fromPlanar({0, 0, 0.8}).linear() * expSo3({0.02, 0, -0.01});
  const double theta_from = -0.4;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = R;
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 3, 6> numeric;
  for (int k = 0; k < 6; ++k) {
    const PlanarPose moved =
        between({0, 0, theta_from}, toPlanar(T * expSe3(kStep * Vector6d::Unit(k))));
    const PlanarPose still = between({0, 0, theta_from}, toPlanar(T));
    numeric.col(k) << moved.x - still.x, moved.y - still.y, moved.theta - still.theta;
  }
  numeric /= kStep;
  const Matrix6d covariance = randomPose(random).covariance;
  const Eigen::Matrix3d expected = numeric * covariance * numeric.transpose();
  const Eigen::Matrix<double, 3, 6> project = planarProjection(R, theta_from);
  const Eigen::Matrix3d got = project * covariance * project.transpose();
  // The heading's derivative is that of a level camera: right to first order in the lean.
  CHECK((expected - got).norm() < 0.03 * expected.norm());
}

}  // namespace tolman::experience_map
