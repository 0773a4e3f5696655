// SPDX-License-Identifier: BSD-3-Clause
// Expansion of pattern sums to derivatives by pose, brightness and inverse depth.
#include "chunk_system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "wide_lanes.hpp"

namespace tolman::direct_sparse {

void ChunkSystem::clear(int host) {
  host_ = host;
  targets_ = 0;
  for (RelativeBlock& block : relative_) {
    for (auto& row : block) row.fill(0);
  }
  for (auto& row : schur_) row.fill(0);
  schur_gradient_.fill(0);
  offset_information = 0;
  offset_gradient = 0;
  energy = 0;
  residuals = 0;
  histogram.fill(0);
}

ResidualState ChunkSystem::judge(const PixelSums& sums, float threshold) {
  constexpr float kLeastGradient = 2;
  const float root = std::min(std::sqrt(sums.energy), 127.0F);
  ++histogram[static_cast<std::size_t>(root)];
  energy += std::min(sums.energy, threshold);
  // Without gradient there is nothing to say; with too much energy it says something wrong.
  if (sums.energy > threshold || sums.xx + sums.yy < kLeastGradient) return ResidualState::Outlier;
  ++residuals;
  return ResidualState::Good;
}

TOLMAN_WIDE_LANES void ChunkSystem::addTemporal(int target, const PairGeometry& pair, const PixelSums& s,
                              const CentreJacobian& J, PointTerms& terms) {
  // Columns of (gx, gy)' W (J_geo | a | b | r): the two image directions share all columns.
  alignas(32) std::array<float, 12> p{};
  alignas(32) std::array<float, 12> q{};
  for (std::size_t i = 0; i < 6; ++i) {
    p[i] = s.xx * J.u_by_twist[i] + s.xy * J.v_by_twist[i];
    q[i] = s.xy * J.u_by_twist[i] + s.yy * J.v_by_twist[i];
  }
  p[6] = s.xa;
  q[6] = s.ya;
  p[7] = -s.x1;
  q[7] = -s.y1;
  p[8] = s.xr;
  q[8] = s.yr;
  const auto slot = static_cast<std::size_t>(target);
  RelativeBlock& block = relative_[slot];
  for (std::size_t i = 0; i < 6; ++i) {
    const float ju = J.u_by_twist[i];
    const float jv = J.v_by_twist[i];
    for (std::size_t k = 0; k < 12; ++k) block[i][k] += ju * p[k] + jv * q[k];
  }
  block[6][6] += s.aa;
  block[6][7] -= s.a1;
  block[6][8] += s.ar;
  block[7][7] += s.w;
  block[7][8] -= s.r1;
  targets_ |= 1U << slot;

  alignas(32) std::array<float, kFrameVariables> c;  // relative variables by inverse depth
  for (std::size_t k = 0; k < kFrameVariables; ++k) {
    c[k] = p[k] * J.u_by_depth + q[k] * J.v_by_depth;
  }
  const float pd = s.xx * J.u_by_depth + s.xy * J.v_by_depth;
  const float qd = s.xy * J.u_by_depth + s.yy * J.v_by_depth;
  terms.information += pd * J.u_by_depth + qd * J.v_by_depth;
  terms.gradient += s.xr * J.u_by_depth + s.yr * J.v_by_depth;
  alignas(32) std::array<float, kFrameVariables> by_host{};
  for (std::size_t k = 0; k < kFrameVariables; ++k) {
    const float* row = pair.relative_by_host.data() + kFrameVariables * k;
    for (std::size_t i = 0; i < kFrameVariables; ++i) by_host[i] += row[i] * c[k];
  }
  float* at_target = terms.coupling.data() + kFrameVariables * slot;
  float* at_host = terms.coupling.data() + kFrameVariables * static_cast<std::size_t>(host_);
  for (std::size_t i = 0; i < kFrameVariables; ++i) {
    at_target[i] += c[i];
    at_host[i] += by_host[i];
  }
  terms.slots |= (1U << slot) | (1U << static_cast<unsigned>(host_));
  ++terms.good;
}

void ChunkSystem::addStereo(const PixelSums& s, float focal_baseline, float lambda,
                            PointTerms& terms) {
  const float xx = lambda * s.xx;
  const float xr = lambda * s.xr;
  terms.information += focal_baseline * focal_baseline * xx;
  terms.gradient -= focal_baseline * xr;
  terms.coupling[kOffsetIndex] -= focal_baseline * xx;
  offset_information += xx;
  offset_gradient += xr;
  ++terms.good;
}

void ChunkSystem::eliminate(std::span<PointTerms> points) {
  constexpr float kLeastInformation = 1e-3F;
  for (PointTerms& point : points) point.information += kLeastInformation;
  PointTerms nothing;
  nothing.information = 1;
  for (std::size_t first = 0; first < points.size(); first += 4) {
    FourPoints four{};
    for (std::size_t p = 0; p < four.size(); ++p) {
      four[p] = first + p < points.size() ? &points[first + p] : &nothing;
    }
    eliminateFour(four);
  }
}

/// Adds to the rows and columns of all variables that any of the four couples with.
TOLMAN_WIDE_LANES void ChunkSystem::eliminateFour(const FourPoints& points) {
  constexpr std::size_t n = kFrameVariables;
  const float* c0 = points[0]->coupling.data();
  const float* c1 = points[1]->coupling.data();
  const float* c2 = points[2]->coupling.data();
  const float* c3 = points[3]->coupling.data();
  const std::array<float, 4> inverse = {1 / points[0]->information, 1 / points[1]->information,
                                        1 / points[2]->information, 1 / points[3]->information};
  const auto addRow = [&](std::size_t i, std::uint32_t slots) TOLMAN_INLINE_LAMBDA {
    const float s0 = c0[i] * inverse[0];
    const float s1 = c1[i] * inverse[1];
    const float s2 = c2[i] * inverse[2];
    const float s3 = c3[i] * inverse[3];
    schur_[i][kOffsetIndex] += (s0 * c0[kOffsetIndex] + s1 * c1[kOffsetIndex]) +
                               (s2 * c2[kOffsetIndex] + s3 * c3[kOffsetIndex]);
    schur_gradient_[i] += (s0 * points[0]->gradient + s1 * points[1]->gradient) +
                          (s2 * points[2]->gradient + s3 * points[3]->gradient);
    for (; slots != 0; slots &= slots - 1) {
      const std::size_t begin = n * static_cast<std::size_t>(std::countr_zero(slots));
      float* out = schur_[i].data() + begin;
      for (std::size_t k = begin; k < begin + n; ++k, ++out) {
        *out += (s0 * c0[k] + s1 * c1[k]) + (s2 * c2[k] + s3 * c3[k]);
      }
    }
  };
  const std::uint32_t all =
      points[0]->slots | points[1]->slots | points[2]->slots | points[3]->slots;
  for (std::uint32_t slots = all; slots != 0; slots &= slots - 1) {  // from the first to the last
    const std::size_t begin = n * static_cast<std::size_t>(std::countr_zero(slots));
    for (std::size_t i = begin; i < begin + n; ++i) addRow(i, slots);
  }
  addRow(kOffsetIndex, 0);
}

}  // namespace tolman::direct_sparse
