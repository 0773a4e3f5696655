// SPDX-License-Identifier: BSD-3-Clause
// Residuals (grey levels) of the eight pattern pixels of a point in another keyframe (Engel et al.,
// PAMI 2018, equation 4) or in the right image of its own (Wang et al., ICCV 2017, static term),
// and their weighted sums for the normal equations.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

using Matrix8f = Eigen::Matrix<float, 8, 8>;
using Vector8f = Eigen::Matrix<float, 8, 1>;

/// Everything about a pair (host, target) that its points share.
///
/// Residuals use the present state, derivatives the first estimate (first-estimate Jacobians).
/// Relative variables: left twist of T_target_host, then a and b of the target.
struct PairGeometry {
  std::array<float, 9> warp{};   ///< K R K^-1, row-major
  std::array<float, 3> shift{};  ///< K t
  float gain = 1;                ///< e^(a_target - a_host)
  float host_b = 0;
  float target_b = 0;
  Eigen::Matrix3f R0 = Eigen::Matrix3f::Identity();
  Eigen::Vector3f t0 = Eigen::Vector3f::Zero();
  /// Derivative of the relative variables by those of the host; that by the target is the identity.
  Eigen::Matrix<float, 8, 8, Eigen::RowMajor> relative_by_host = Matrix8f::Zero();
};

PairGeometry pairGeometry(const Pinhole& camera, const Keyframe& host, const Keyframe& target);

/// Weighted sums over the pattern: gradient (x, y), derivative by a of the residual (a), residual
/// (r), weight (1). The derivative by b is -1.
struct PixelSums {
  float xx = 0, xy = 0, yy = 0, xa = 0, ya = 0, x1 = 0, y1 = 0, aa = 0, a1 = 0, w = 0;
  float xr = 0, yr = 0, ar = 0, r1 = 0;
  float energy = 0;  ///< of the Huber norm
};

/// Derivatives of the pixel of the pattern's centre.
struct CentreJacobian {
  alignas(32) std::array<float, 8> u_by_twist{};  ///< six, and two zeros
  alignas(32) std::array<float, 8> v_by_twist{};
  float u_by_depth = 0;  ///< inverse depth
  float v_by_depth = 0;
};

/// Where the pixels of a point's pattern are in a target, px.
struct PatternPlaces {
  alignas(32) std::array<float, kPatternSize> u;
  alignas(32) std::array<float, kPatternSize> v;
  bool inside = false;  ///< false: it leaves the image or lies behind the camera; no other value
};

/// Also asks for the pixels' memory, so place some points before the first sum.
void placePattern(const PairGeometry& pair, const GrayLevel& target, const Point& point,
                  PatternPlaces& places);
/// The places must be inside.
PixelSums temporalSums(const PairGeometry& pair, const GrayLevel& target, const Pattern& pattern,
                       const PatternPlaces& places);
CentreJacobian centreJacobian(const Pinhole& camera, const PairGeometry& pair, float u, float v,
                              float inverse_depth);

/// The right image as a target: pixel (u - focal * baseline * inverse_depth + offset, v).
struct StereoGeometry {
  float focal_baseline = 0;  ///< px m
  float offset = 0;          ///< px
  float gain = 1;
  float brightness = 0;  ///< right = gain * left + brightness
};

/// Only xx, xr and energy are filled: the row is the only direction.
bool stereoSums(const StereoGeometry& stereo, const GrayLevel& right, const Point& point,
                PixelSums& sums);

/// A point where another keyframe sees it, with the derivatives of its inverse depth there.
struct Sighting {
  int u = 0;  ///< nearest pixel
  int v = 0;
  float inverse_depth = 0;                      ///< 1/m, in the target
  alignas(32) std::array<float, 8> by_twist{};  ///< six, and two zeros
  float by_depth = 0;                           ///< by the inverse depth in the host
};

/// The sighting at the nearest pixel of the target; empty outside of the image. The pattern to
/// compare with the target's right image is that of the target at this pixel, because the host has
/// another view.
std::optional<Sighting> sight(const Pinhole& camera, const PairGeometry& pair,
                              const GrayLevel& target, const Point& point);

/// Asks for the memory of the pixels that stereoSums() will read. Images are larger than the caches
/// near the processor, so call this some points ahead.
void prefetchStereo(const StereoGeometry& stereo, const GrayLevel& right, const Point& point);
/// The same for patternAt().
void prefetchPattern(const GrayLevel& image, int u, int v);

}  // namespace tolman::direct_sparse
