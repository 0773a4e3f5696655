// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/mirror_hint.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {
namespace {

/// Root mean square errors, m, after the best rotation and the best reflection about the mean.
struct Fits {
  double rotation = 0;
  double reflection = 0;
};

Eigen::Matrix3Xd centredPositions(const Trajectory& poses) {
  Eigen::Matrix3Xd positions(3, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    positions.col(static_cast<Eigen::Index>(i)) = poses[i].T_world_camera.translation();
  }
  return positions.colwise() - positions.rowwise().mean();
}

/// Of all orthogonal matrices R, |T - R E|^2 = |T|^2 + |E|^2 - 2 tr(R E T'), and the trace is at
/// most the sum of the singular values; of the other handedness the last one has the other sign.
Fits fitsOf(const Matches& aligned) {
  const Eigen::Matrix3Xd truth = centredPositions(aligned.truth);
  const Eigen::Matrix3Xd estimate = centredPositions(aligned.estimate);
  const Eigen::Matrix3d products = truth * estimate.transpose();
  const Eigen::Vector3d s = Eigen::JacobiSVD<Eigen::Matrix3d>(products).singularValues();
  const double last = products.determinant() < 0 ? -s[2] : s[2];
  const double squares = truth.squaredNorm() + estimate.squaredNorm();
  const auto rmse = [&](double trace) {
    return std::sqrt(std::max(0.0, squares - 2 * trace) / static_cast<double>(truth.cols()));
  };
  return {rmse(s[0] + s[1] + last), rmse(s[0] + s[1] - last)};
}

}  // namespace

std::string mirrorHint(const Matches& aligned) {
  constexpr double kBetter = 5;    // chosen, not tuned
  constexpr double kSmall = 1e-4;  // of the true path; chosen, not tuned
  constexpr std::size_t kFewest = 10;
  if (aligned.truth.size() < kFewest) return "";
  const Fits fits = fitsOf(aligned);
  const bool is_small = fits.rotation <= kSmall * pathLength(aligned.truth);
  if (is_small || fits.rotation < kBetter * fits.reflection) return "";
  return fmt::format(
      "the true path agrees with the mirror image of the estimate, to {:.3g} m instead of "
      "{:.3g} m: does an axis of the positions of one of the two have the wrong sign, or is its "
      "coordinate system left-handed? All errors are wrong if so",
      fits.reflection, fits.rotation);
}

}  // namespace tolman::evaluation
