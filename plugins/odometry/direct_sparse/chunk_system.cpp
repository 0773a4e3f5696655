// SPDX-License-Identifier: BSD-3-Clause
// Expansion of pattern sums to derivatives by pose, brightness and inverse depth.
#include "chunk_system.hpp"

#include <algorithm>
#include <cmath>

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

void ChunkSystem::addTemporal(int target, const PairGeometry& pair, const PixelSums& s,
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

  Vector8f c;  // relative variables by inverse depth
  for (int i = 0; i < 8; ++i) {
    const auto k = static_cast<std::size_t>(i);
    c[i] = p[k] * J.u_by_depth + q[k] * J.v_by_depth;
  }
  const float pd = s.xx * J.u_by_depth + s.xy * J.v_by_depth;
  const float qd = s.xy * J.u_by_depth + s.yy * J.v_by_depth;
  terms.information += pd * J.u_by_depth + qd * J.v_by_depth;
  terms.gradient += s.xr * J.u_by_depth + s.yr * J.v_by_depth;
  const Vector8f by_host = pair.relative_by_host.transpose() * c;
  float* at_target = terms.coupling.data() + kFrameVariables * slot;
  float* at_host = terms.coupling.data() + kFrameVariables * static_cast<std::size_t>(host_);
  for (int i = 0; i < kFrameVariables; ++i) {
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

void ChunkSystem::eliminate(PointTerms& terms) {
  constexpr float kLeastInformation = 1e-3F;
  terms.information += kLeastInformation;
  const float inverse = 1.0F / terms.information;
  const auto& c = terms.coupling;
  for (std::size_t a = 0; a < kSlots; ++a) {
    if (((terms.slots >> a) & 1U) == 0) continue;
    for (std::size_t i = kFrameVariables * a; i < kFrameVariables * (a + 1); ++i) {
      const float scaled = c[i] * inverse;
      for (std::size_t b = a; b < kSlots; ++b) {
        if (((terms.slots >> b) & 1U) == 0) continue;
        float* out = schur_[i].data() + kFrameVariables * b;
        const float* in = c.data() + kFrameVariables * b;
        for (std::size_t k = 0; k < kFrameVariables; ++k) out[k] += scaled * in[k];
      }
      schur_[i][kOffsetIndex] += scaled * c[kOffsetIndex];
      schur_gradient_[i] += scaled * terms.gradient;
    }
  }
  const float scaled = c[kOffsetIndex] * inverse;
  schur_[kOffsetIndex][kOffsetIndex] += scaled * c[kOffsetIndex];
  schur_gradient_[kOffsetIndex] += scaled * terms.gradient;
}

}  // namespace tolman::direct_sparse
