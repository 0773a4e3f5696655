// SPDX-License-Identifier: BSD-3-Clause
// Projection, interpolation and weighted sums over the pattern.
#include "photometric_residual.hpp"

#include <cmath>

#include "lanes.hpp"

namespace tolman::direct_sparse {
namespace {

constexpr float kBorder = 2;             // px that projections keep from the border
constexpr float kSmallestDepth = 1e-3F;  // of the host's depth; keeps the division finite
constexpr std::size_t kCentre = 4;       // of the pattern
static_assert(kPatternU[kCentre] == 0 && kPatternV[kCentre] == 0);

/// Reads a pixel at once. A prefetch of memory whose page is not in the TLB has no effect; after
/// this, it has one for the rows near the pixel.
TOLMAN_INLINE void loadPage(const GrayLevel& image, float u, float v) {
  const volatile std::uint8_t* row = image.row(static_cast<int>(v));
  (void)row[static_cast<int>(u)];
}

/// Asks for the memory of the rows v + first ... v + last at column u. A row of the pattern is much
/// shorter than a cache line.
TOLMAN_INLINE void prefetchRows(const GrayLevel& image, float u, float v, int first, int last) {
  const std::uint8_t* p = image.row(static_cast<int>(v)) + static_cast<int>(u);
  for (int row = first; row <= last; ++row) {
    __builtin_prefetch(p + static_cast<std::ptrdiff_t>(row) * image.width);
  }
}

/// Pixels of the pattern in the target; false when one is not usable.
TOLMAN_INLINE bool projectPattern(const PairGeometry& pair, const GrayLevel& target,
                                  const Point& point, Eight& u, Eight& v) {
  constexpr Eight kU = {0, -1, 1, -2, 0, 2, -1, 0};  // kPatternU
  constexpr Eight kV = {-2, -1, -1, 0, 0, 0, 1, 2};
  const auto& m = pair.warp;
  const float d = point.inverse_depth;
  const float x0 = m[0] * point.u + m[1] * point.v + m[2] + pair.shift[0] * d;
  const float y0 = m[3] * point.u + m[4] * point.v + m[5] + pair.shift[1] * d;
  const float z0 = m[6] * point.u + m[7] * point.v + m[8] + pair.shift[2] * d;
  if (!(z0 > kSmallestDepth)) return false;
  const float width = static_cast<float>(target.width) - 1.0F - kBorder;
  const float height = static_cast<float>(target.height) - 1.0F - kBorder;
  const Eight scale = 1.0F / (z0 + m[6] * kU + m[7] * kV);
  u = (x0 + m[0] * kU + m[1] * kV) * scale;
  v = (y0 + m[3] * kU + m[4] * kV) * scale;
  return all((u >= kBorder) & (v >= kBorder) & (u < width) & (v < height));
}

TOLMAN_INLINE Four folded(Eight v) { return lowHalf(v) + highHalf(v); }

TOLMAN_INLINE PixelSums addUp(const PairGeometry& pair, const Pattern& pattern,
                              const GradientSamples& s) {
  const Eight scene = pair.gain * (loadEight(pattern.value.data()) - pair.host_b);
  const Eight r = s.value - scene - pair.target_b;
  const Eight huber = smaller(Eight{} + 1.0F, kHuber / (absolute(r) + 1e-6F));
  const Eight w = loadEight(pattern.weight.data()) * huber;
  const Eight wx = w * s.gx;
  const Eight wy = w * s.gy;
  const Eight wa = -w * scene;
  const Four xx =
      sums(folded(wx * s.gx), folded(wx * s.gy), folded(wy * s.gy), folded(-wx * scene));
  const Four ya = sums(folded(-wy * scene), folded(wx), folded(wy), folded(-wa * scene));
  const Four a1 = sums(folded(wa), folded(w), folded(wx * r), folded(wy * r));
  const Four ar = sums(folded(wa * r), folded(w * r), folded(w * (2.0F - huber) * r * r), four(0));
  return {xx[0], xx[1], xx[2], xx[3], ya[0], ya[1], ya[2], ya[3],
          a1[0], a1[1], a1[2], a1[3], ar[0], ar[1], ar[2]};
}

/// Catmull-Rom value and central-difference slope between b and c. Bilinear interpolation blurs by
/// an amount that depends on the fraction, which biases disparities towards half pixels.
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

TOLMAN_WIDE_LANES void placePattern(const PairGeometry& pair, const GrayLevel& target,
                                    const Point& point, PatternPlaces& places) {
  Eight u;
  Eight v;
  places.inside = projectPattern(pair, target, point, u, v);
  if (!places.inside) return;
  store(u, places.u.data());
  store(v, places.v.data());
  prefetchRows(target, u[kCentre], v[kCentre], -kPatternRadius - 1, kPatternRadius + 2);
}

TOLMAN_WIDE_LANES PixelSums temporalSums(const PairGeometry& pair, const GrayLevel& target,
                                         const Pattern& pattern, const PatternPlaces& places) {
  return addUp(pair, pattern,
               gradientSamples(target, loadEight(places.u.data()), loadEight(places.v.data())));
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
  const float d = inverse_depth * scale;  // inverse depth in the target
  CentreJacobian J;
  J.u_by_twist = {fx * d, 0, -fx * d * x, -fx * x * y, fx * (1 + x * x), -fx * y};
  J.v_by_twist = {0, fy * d, -fy * d * y, -fy * (1 + y * y), fy * x * y, fy * x};
  J.u_by_depth = fx * scale * (pair.t0.x() - x * pair.t0.z());
  J.v_by_depth = fy * scale * (pair.t0.y() - y * pair.t0.z());
  return J;
}

TOLMAN_WIDE_LANES bool stereoSums(const StereoGeometry& stereo, const GrayLevel& right,
                                  const Point& point, PixelSums& sums) {
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

std::optional<Sighting> sight(const Pinhole& camera, const PairGeometry& pair,
                              const GrayLevel& target, const Point& point) {
  const auto& m = pair.warp;
  const float d = point.inverse_depth;
  const float z = m[6] * point.u + m[7] * point.v + m[8] + pair.shift[2] * d;
  if (!(z > kSmallestDepth)) return std::nullopt;
  const float u = (m[0] * point.u + m[1] * point.v + m[2] + pair.shift[0] * d) / z;
  const float v = (m[3] * point.u + m[4] * point.v + m[5] + pair.shift[1] * d) / z;
  if (!target.contains(u, v, kPatternRadius + 2)) return std::nullopt;
  const Eigen::Vector3f ray(
      (point.u - static_cast<float>(camera.cx)) / static_cast<float>(camera.fx),
      (point.v - static_cast<float>(camera.cy)) / static_cast<float>(camera.fy), 1.0F);
  const Eigen::Vector3f turned = pair.R0 * ray;
  const Eigen::Vector3f p = turned + pair.t0 * d;
  const float scale = 1.0F / p.z();
  const float e = d * scale;  // inverse depth in the target at the first estimate
  Sighting sighting;
  sighting.u = static_cast<int>(u + 0.5F);
  sighting.v = static_cast<int>(v + 0.5F);
  sighting.inverse_depth = d / z;
  sighting.by_twist = {0, 0, -e * e, -e * p.y() * scale, e * p.x() * scale, 0};
  sighting.by_depth = turned.z() * scale * scale;
  return sighting;
}

void prefetchStereo(const StereoGeometry& stereo, const GrayLevel& right, const Point& point) {
  const float u = point.u - stereo.focal_baseline * point.inverse_depth + stereo.offset;
  if (!right.contains(u, point.v, kPatternRadius + 1)) return;
  loadPage(right, u, point.v);
  prefetchRows(right, u, point.v, -kPatternRadius, kPatternRadius);
}

void prefetchPattern(const GrayLevel& image, int u, int v) {
  prefetchRows(image, static_cast<float>(u), static_cast<float>(v), -kPatternRadius - 1,
               kPatternRadius + 1);
}

}  // namespace tolman::direct_sparse
