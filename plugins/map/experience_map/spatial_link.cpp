// SPDX-License-Identifier: BSD-3-Clause
#include "spatial_link.hpp"

#include <array>

namespace tolman::experience_map {
namespace {

/// ad(r) n: the commutator of two twists.
Matrix6d commutator(const Vector6d& r) {
  Matrix6d ad = Matrix6d::Zero();
  ad.topLeftCorner<3, 3>() = skew(r.tail<3>());
  ad.bottomRightCorner<3, 3>() = skew(r.tail<3>());
  ad.topRightCorner<3, 3>() = skew(r.head<3>());
  return ad;
}

/// J(r) = sum over n of B_n / n! * (-ad r)^n with the Bernoulli numbers B_n (B_1 = -1/2). Converges
/// below a turn of 2 pi; after the tenth power the rest is below 1e-3 even at pi.
Matrix6d inverseRightJacobian(const Vector6d& r) {
  constexpr std::array kEven = {1.0 / 12, -1.0 / 720, 1.0 / 30240, -1.0 / 1209600, 1.0 / 47900160};
  const Matrix6d ad = commutator(r);
  const Matrix6d squared = ad * ad;
  Matrix6d sum = Matrix6d::Identity() + 0.5 * ad;
  Matrix6d power = squared;
  for (const double factor : kEven) {
    sum += factor * power;
    if (power.cwiseAbs().maxCoeff() < 1e-12) break;
    power = power * squared;
  }
  return sum;
}

}  // namespace

Vector6d residualOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                    const Eigen::Isometry3d& to) {
  return logSe3(link.pose.inverse() * (from.inverse() * to));
}

LinkDerivatives<Space> derivativesOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                                     const Eigen::Isometry3d& to) {
  LinkDerivatives<Space> by;
  by.by_to = inverseRightJacobian(residualOf(link, from, to));
  by.by_from = -by.by_to * adjointSe3(to.inverse() * from);
  return by;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6d& step) {
  return normalised(pose * expSe3(step));
}

}  // namespace tolman::experience_map
