// SPDX-License-Identifier: BSD-3-Clause
// Projection, interpolation and weighted sums over the pattern.
#include "photometric_residual.hpp"

#include <cmath>

#include "wide_lanes.hpp"

namespace tolman::direct_sparse {
namespace {

constexpr float kBorder = 2;             // px that projections keep from the border
constexpr float kSmallestDepth = 1e-3F;  // of the host's depth

/// Half of the pattern in the target.
struct Half {
  Four u;
  Four v;
};

/// Pixels of the pattern in the target; false when one is not usable.
TOLMAN_INLINE bool projectPattern(const PairGeometry& pair, const GradientImage& target, const Point& point,
                    std::array<Half, 2>& halves) {
  static constexpr std::array<Four, 2> kU = {Four{0, -1, 1, -2}, Four{0, 2, -1, 0}};
  static constexpr std::array<Four, 2> kV = {Four{-2, -1, -1, 0}, Four{0, 0, 1, 2}};
  const auto& m = pair.warp;
  const float d = point.inverse_depth;
  const float x0 = m[0] * point.u + m[1] * point.v + m[2] + pair.shift[0] * d;
  const float y0 = m[3] * point.u + m[4] * point.v + m[5] + pair.shift[1] * d;
  const float z0 = m[6] * point.u + m[7] * point.v + m[8] + pair.shift[2] * d;
  if (!(z0 > kSmallestDepth)) return false;
  const float width = static_cast<float>(target.width()) - 1.0F - kBorder;
  const float height = static_cast<float>(target.height()) - 1.0F - kBorder;
  FourInts inside = {-1, -1, -1, -1};
  for (std::size_t h = 0; h < 2; ++h) {
    const Four scale = 1.0F / (z0 + m[6] * kU[h] + m[7] * kV[h]);
    const Four u = (x0 + m[0] * kU[h] + m[1] * kV[h]) * scale;
    const Four v = (y0 + m[3] * kU[h] + m[4] * kV[h]) * scale;
    inside &= (u >= kBorder) & (v >= kBorder) & (u < width) & (v < height);
    halves[h] = {u, v};
  }
  return all(inside);
}

/// What one half of the pattern adds to the sums, lane by lane.
struct HalfSums {
  Four xx, xy, yy, xa, ya, x1, y1, aa, a1, w, xr, yr, ar, r1, energy;
};

TOLMAN_INLINE HalfSums addUp(const PairGeometry& pair, const Pattern& pattern, std::size_t h, Four value, Four gx,
               Four gy) {
  const Four omega = loadFour(pattern.weight.data() + 4 * h);
  const Four scene = pair.gain * (loadFour(pattern.value.data() + 4 * h) - pair.host_b);
  const Four r = value - scene - pair.target_b;
  const Four size = absolute(r);
  const Four huber = smaller(four(1.0F), kHuber / (size + 1e-6F));
  const Four w = omega * huber;
  const Four wx = w * gx;
  const Four wy = w * gy;
  const Four wa = -w * scene;
  return {wx * gx, wx * gy, wy * gy,     -wx * scene, -wy * scene,
          wx,      wy,      -wa * scene, wa,          w,
          wx * r,  wy * r,  wa * r,      w * r,       w * (2.0F - huber) * r * r};
}

TOLMAN_INLINE PixelSums combined(const HalfSums& a, const HalfSums& b) {
  const Four s0 = sums(a.xx + b.xx, a.xy + b.xy, a.yy + b.yy, a.xa + b.xa);
  const Four s1 = sums(a.ya + b.ya, a.x1 + b.x1, a.y1 + b.y1, a.aa + b.aa);
  const Four s2 = sums(a.a1 + b.a1, a.w + b.w, a.xr + b.xr, a.yr + b.yr);
  const Four s3 = sums(a.ar + b.ar, a.r1 + b.r1, a.energy + b.energy, four(0));
  return {s0[0], s0[1], s0[2], s0[3], s1[0], s1[1], s1[2], s1[3],
          s2[0], s2[1], s2[2], s2[3], s3[0], s3[1], s3[2]};
}

/// Catmull-Rom value and central-difference slope between b and c. Bilinear values are blurred by
/// an amount that changes with the fraction, which pulls disparities to half pixels.
struct RowSamples {
  Four value;
  Four slope;
};
TOLMAN_INLINE RowSamples rowSamples(Four a, Four b, Four c, Four d, float f) {
  const Four left = 0.5F * (c - a);
  const Four right = 0.5F * (d - b);
  const Four k3 = left + right - 2.0F * (c - b);
  const Four k2 = (c - b) - left - k3;
  return {b + f * (left + f * (k2 + f * k3)), left + f * (right - left)};
}

}  // namespace

PairGeometry pairGeometry(const Pinhole& camera, const Keyframe& host, const Keyframe& target) {
  PairGeometry pair;
  const Eigen::Isometry3d T = target.T_camera_world() * host.T_world_camera();
  const Eigen::Isometry3d T0 = target.T0_camera_world * host.T0_camera_world.inverse();
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();
  K(0, 0) = camera.fx;
  K(1, 1) = camera.fy;
  K(0, 2) = camera.cx;
  K(1, 2) = camera.cy;
  const Eigen::Matrix3d warp = K * T.linear() * K.inverse();
  const Eigen::Vector3d shift = K * T.translation();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      pair.warp[static_cast<std::size_t>(3 * r + c)] = static_cast<float>(warp(r, c));
    }
    pair.shift[static_cast<std::size_t>(r)] = static_cast<float>(shift[r]);
  }
  pair.gain = static_cast<float>(std::exp(target.affine().a - host.affine().a));
  pair.host_b = static_cast<float>(host.affine().b);
  pair.target_b = static_cast<float>(target.affine().b);
  pair.R0 = T0.linear().cast<float>();
  pair.t0 = T0.translation().cast<float>();
  // T_target_host becomes exp(xi_t) T exp(-xi_h), so the relative twist is xi_t - Ad(T) xi_h.
  Eigen::Matrix<double, 8, 8> by_host = Eigen::Matrix<double, 8, 8>::Zero();
  by_host.block<3, 3>(0, 0) = -T0.linear();
  by_host.block<3, 3>(3, 3) = -T0.linear();
  by_host.block<3, 3>(0, 3) = -skew(T0.translation()) * T0.linear();
  by_host(6, 6) = -1;
  by_host(7, 7) = -std::exp(target.affine0.a - host.affine0.a);
  pair.relative_by_host = by_host.cast<float>();
  return pair;
}

TOLMAN_WIDE_LANES bool temporalSums(const PairGeometry& pair, const GradientImage& target, const Point& point,
                  PixelSums& sums) {
  std::array<Half, 2> halves;
  if (!projectPattern(pair, target, point, halves)) return false;
  std::array<HalfSums, 2> parts;
  for (std::size_t h = 0; h < 2; ++h) {
    const FourInts x = truncated(halves[h].u);
    const FourInts y = truncated(halves[h].v);
    const Four fx = halves[h].u - toFloat(x);
    const Four fy = halves[h].v - toFloat(y);
    Four value = target.at(x[0], y[0], fx[0], fy[0]);
    Four gx = target.at(x[1], y[1], fx[1], fy[1]);
    Four gy = target.at(x[2], y[2], fx[2], fy[2]);
    Four nothing = target.at(x[3], y[3], fx[3], fy[3]);
    transpose(value, gx, gy, nothing);
    parts[h] = addUp(pair, point.pattern, h, value, 0.5F * gx, 0.5F * gy);
  }
  sums = combined(parts[0], parts[1]);
  return true;
}

void prefetchTemporal(const PairGeometry& pair, const GradientImage& target, const Point& point) {
  const auto& m = pair.warp;
  const float d = point.inverse_depth;
  const float z = m[6] * point.u + m[7] * point.v + m[8] + pair.shift[2] * d;
  const float u = (m[0] * point.u + m[1] * point.v + m[2] + pair.shift[0] * d) / z;
  const float v = (m[3] * point.u + m[4] * point.v + m[5] + pair.shift[1] * d) / z;
  constexpr float kReach = kPatternRadius + 1;
  if (!(z > kSmallestDepth) || !target.contains(u, v, kReach)) return;
  const int x = static_cast<int>(u);
  const int y = static_cast<int>(v);
  for (int row = y - kPatternRadius; row <= y + kPatternRadius + 1; ++row) {
    // A row of the pattern has less bytes than a cache line, but may lie across two.
    __builtin_prefetch(target.pixel(x - kPatternRadius, row));
    __builtin_prefetch(target.pixel(x + kPatternRadius + 1, row));
  }
}

CentreJacobian centreJacobian(const Pinhole& camera, const PairGeometry& pair, float u, float v,
                              float inverse_depth) {
  const auto fx = static_cast<float>(camera.fx);
  const auto fy = static_cast<float>(camera.fy);
  const Eigen::Vector3f ray((u - static_cast<float>(camera.cx)) / fx,
                            (v - static_cast<float>(camera.cy)) / fy, 1.0F);
  const Eigen::Vector3f p = pair.R0 * ray + pair.t0 * inverse_depth;
  const float scale = 1.0F / p.z();
  const float x = p.x() * scale;
  const float y = p.y() * scale;
  const float d = inverse_depth * scale;  // in the target
  CentreJacobian J;
  J.u_by_twist = {fx * d, 0, -fx * d * x, -fx * x * y, fx * (1 + x * x), -fx * y};
  J.v_by_twist = {0, fy * d, -fy * d * y, -fy * (1 + y * y), fy * x * y, fy * x};
  J.u_by_depth = fx * scale * (pair.t0.x() - x * pair.t0.z());
  J.v_by_depth = fy * scale * (pair.t0.y() - y * pair.t0.z());
  return J;
}

TOLMAN_WIDE_LANES bool stereoSums(const StereoGeometry& stereo, const GrayLevel& right, const Point& point,
                PixelSums& sums) {
  const float u = point.u - stereo.focal_baseline * point.inverse_depth + stereo.offset;
  constexpr float kMargin = kPatternRadius + 1;
  if (!right.contains(u, point.v, kMargin)) return false;
  const int x = static_cast<int>(u);
  const int y = static_cast<int>(point.v);
  const float f = u - static_cast<float>(x);
  const auto row = [&](std::size_t k) {
    return loadBytes(right.row(y + kPatternV[k]) + x + kPatternU[k] - 1);
  };
  std::array<Four, 3> parts{};
  for (std::size_t h = 0; h < 2; ++h) {
    Four a = row(4 * h);
    Four b = row(4 * h + 1);
    Four c = row(4 * h + 2);
    Four d = row(4 * h + 3);
    transpose(a, b, c, d);
    const RowSamples samples = rowSamples(a, b, c, d, f);
    const Four scene = stereo.gain * loadFour(point.pattern.value.data() + 4 * h);
    const Four r = samples.value - scene - stereo.brightness;
    const Four huber = smaller(four(1.0F), kHuber / (absolute(r) + 1e-6F));
    const Four w = loadFour(point.pattern.weight.data() + 4 * h) * huber;
    parts[0] += w * samples.slope * samples.slope;
    parts[1] += w * samples.slope * r;
    parts[2] += w * (2.0F - huber) * r * r;
  }
  const Four total = direct_sparse::sums(parts[0], parts[1], parts[2], four(0));
  sums = PixelSums();
  sums.xx = total[0];
  sums.xr = total[1];
  sums.energy = total[2];
  return true;
}

}  // namespace tolman::direct_sparse
