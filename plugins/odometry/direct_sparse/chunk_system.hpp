// SPDX-License-Identifier: BSD-3-Clause
// Normal equations of a chunk of points of one host keyframe, summed in float: the inner loop of
// the bundle adjustment.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "lanes.hpp"
#include "photometric_residual.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

/// Variables padded to whole SIMD registers.
inline constexpr std::size_t kPadded = 80;
static_assert(kPadded >= kVariables && kPadded % 8 == 0);

/// Terms of the inverse depth of one point in the normal equations, at the first estimates.
struct PointTerms {
  alignas(32) std::array<float, kPadded> coupling{};
  float information = 0;    ///< H_dd
  float gradient = 0;       ///< b_d
  std::uint32_t slots = 0;  ///< bit mask of the slots whose variables have a coupling
  int good = 0;             ///< residuals in the sums
};

/// Accumulates the points of one host. A chunk is small enough for sums in float.
class ChunkSystem {
 public:
  using FieldTerms = Eigen::Matrix<float, kFieldVariables, 1>;
  void clear(int host);
  int host() const { return host_; }

  /// Good or Outlier; counts energy and residuals.
  ResidualState judge(const PixelSums& sums, float threshold);
  void addTemporal(int target, const PairGeometry& pair, const PixelSums& sums,
                   const CentreJacobian& J, PointTerms& terms);
  /// Static residual in the host's right image. `sums`: of stereoSums(); `lambda`: the paper's;
  /// `by_field`: derivatives of the column by the field.
  void addStereo(const PixelSums& sums, float focal_baseline, float lambda,
                 const FieldTerms& by_field, PointTerms& terms);
  /// Static residual in the right image of the target.
  void addSighting(int target, const PairGeometry& pair, const PixelSums& sums,
                   const Sighting& sighting, float focal_baseline, float lambda,
                   const FieldTerms& by_field, PointTerms& terms);
  /// Computes the Schur complement of the points, after all their residuals were added.
  void eliminate(std::span<PointTerms> points);

  /// Sums over points. Rows 0 to 7 are the relative variables (twist, a, b); column 8 is the
  /// gradient, columns from 9 on are the couplings with the field of disparity errors.
  using RelativeBlock = std::array<std::array<float, 24>, 8>;
  const RelativeBlock& relative(int target) const {
    return relative_[static_cast<std::size_t>(target)];
  }
  bool hasTarget(int target) const { return (targets_ >> static_cast<unsigned>(target)) & 1U; }
  /// The Schur complement to subtract, blocks (i, j) with slot(i) <= slot(j) only, and the rows
  /// of the field.
  const std::array<std::array<float, kPadded>, kPadded>& schur() const { return schur_; }
  float schurGradient(std::size_t variable) const;
  Eigen::Matrix<float, 16, kFieldVariables> field_information;  ///< columns padded to registers
  FieldTerms field_gradient;
  ScaleMoments<float> moments;  ///< of the static residuals
  double energy = 0;
  int residuals = 0;
  std::array<int, 128> histogram{};  ///< of square roots of pattern energies, with outliers

 private:
  void addToField(float xx, float xr, const FieldTerms& by_field);
  void couple(int target, const PairGeometry& pair, const Eight& by_depth, PointTerms& terms) const;
  using FourPoints = std::array<const PointTerms*, 4>;  // each sum is loaded once for four points
  void eliminateFour(const FourPoints& points);

  int host_ = 0;
  std::uint32_t targets_ = 0;
  alignas(32) std::array<RelativeBlock, kSlots> relative_;
  alignas(32) std::array<std::array<float, kPadded>, kPadded> schur_;
};

}  // namespace tolman::direct_sparse
