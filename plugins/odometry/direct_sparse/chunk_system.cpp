// SPDX-License-Identifier: BSD-3-Clause
// Expansion of pattern sums to derivatives by pose, brightness and inverse depth.
#include "chunk_system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "lanes.hpp"

namespace tolman::direct_sparse {
namespace {

static_assert(kFrameVariables == 8);

TOLMAN_INLINE void add(Eight value, float* sum) {
  value += loadEight(sum);
  std::memcpy(sum, &value, sizeof value);
}

/// The column after those of the field, within the padding behind the columns of the slots.
constexpr std::size_t kGradientIndex = kOffsetIndex + kFieldVariables;
static_assert(kGradientIndex < kPadded);
constexpr auto kFields = static_cast<std::size_t>(kFieldVariables);

void coupleField(float weight, const ChunkSystem::FieldTerms& by_field, PointTerms& terms) {
  for (std::size_t k = 0; k < kFields; ++k) {
    terms.coupling[kOffsetIndex + k] += weight * by_field[static_cast<int>(k)];
  }
}

}  // namespace

void ChunkSystem::clear(int host) {
  host_ = host;
  targets_ = 0;
  for (RelativeBlock& block : relative_) {
    for (auto& row : block) row.fill(0);
  }
  for (auto& row : schur_) row.fill(0);
  field_information.setZero();
  field_gradient.setZero();
  moments = ScaleMoments<float>();
  energy = 0;
  residuals = 0;
  histogram.fill(0);
}

ResidualState ChunkSystem::judge(const PixelSums& sums, float threshold) {
  constexpr float kMinGradient = 2;  // squared grey levels / px^2; as in DSO
  const float root = std::min(std::sqrt(sums.energy), 127.0F);
  ++histogram[static_cast<std::size_t>(root)];
  energy += std::min(sums.energy, threshold);
  // Without gradient the residual has no information; with a high energy it is wrong.
  if (sums.energy > threshold || sums.xx + sums.yy < kMinGradient) return ResidualState::Outlier;
  ++residuals;
  return ResidualState::Good;
}

/// The same sums as with the type FieldTerms, in whole registers.
TOLMAN_INLINE void ChunkSystem::addToField(float xx, float xr, const FieldTerms& by_field) {
  static_assert(kFields > 8 && kFields <= 16);
  const Eight first = loadEight(by_field.data());
  Eight others{};
  for (std::size_t k = 8; k < kFields; ++k) others[k - 8] = by_field[static_cast<int>(k)];
  for (int column = 0; column < kFieldVariables; ++column) {
    const float weight = xx * by_field[column];
    float* sum = field_information.col(column).data();
    add(weight * first, sum);
    add(weight * others, sum + 8);
  }
  field_gradient += xr * by_field;
}

TOLMAN_WIDE_LANES void ChunkSystem::addTemporal(int target, const PairGeometry& pair,
                                                const PixelSums& s, const CentreJacobian& J,
                                                PointTerms& terms) {
  // Columns of (gx, gy)' W (J_geo | a | b): the two image directions share all columns.
  const Eight ju = loadEight(J.u_by_twist.data());
  const Eight jv = loadEight(J.v_by_twist.data());
  Eight p = s.xx * ju + s.xy * jv;
  Eight q = s.xy * ju + s.yy * jv;
  p[6] = s.xa;
  q[6] = s.ya;
  p[7] = -s.x1;
  q[7] = -s.y1;
  const auto slot = static_cast<std::size_t>(target);
  RelativeBlock& block = relative_[slot];
  for (std::size_t i = 0; i < 6; ++i) {
    add(J.u_by_twist[i] * p + J.v_by_twist[i] * q, block[i].data());
    block[i][8] += J.u_by_twist[i] * s.xr + J.v_by_twist[i] * s.yr;
  }
  block[6][6] += s.aa;
  block[6][7] -= s.a1;
  block[6][8] += s.ar;
  block[7][7] += s.w;
  block[7][8] -= s.r1;
  targets_ |= 1U << slot;

  const Eight by_depth = p * J.u_by_depth + q * J.v_by_depth;
  const float pd = s.xx * J.u_by_depth + s.xy * J.v_by_depth;
  const float qd = s.xy * J.u_by_depth + s.yy * J.v_by_depth;
  terms.information += pd * J.u_by_depth + qd * J.v_by_depth;
  terms.gradient += s.xr * J.u_by_depth + s.yr * J.v_by_depth;
  couple(target, pair, by_depth, terms);
  ++terms.good;
}

TOLMAN_WIDE_LANES void ChunkSystem::addSighting(int target, const PairGeometry& pair,
                                                const PixelSums& s, const Sighting& sighting,
                                                float focal_baseline, float lambda,
                                                const FieldTerms& by_field, PointTerms& terms) {
  const float xx = lambda * s.xx;
  const float xr = lambda * s.xr;
  const Eight by_twist = -focal_baseline * loadEight(sighting.by_twist.data());
  const float by_depth = -focal_baseline * sighting.by_depth;
  const auto slot = static_cast<std::size_t>(target);
  RelativeBlock& block = relative_[slot];
  for (std::size_t i = 2; i < 5; ++i) {  // only z, pitch and yaw change the depth
    add(by_twist[i] * xx * by_twist, block[i].data());
    block[i][8] += by_twist[i] * xr;
    const float weight = by_twist[i] * xx;
    for (std::size_t k = 0; k < kFields; ++k) {
      block[i][9 + k] += weight * by_field[static_cast<int>(k)];
    }
  }
  targets_ |= 1U << slot;
  terms.information += by_depth * by_depth * xx;
  terms.gradient += by_depth * xr;
  coupleField(by_depth * xx, by_field, terms);
  addToField(xx, xr, by_field);
  couple(target, pair, by_depth * xx * by_twist, terms);
}

/// Adds the coupling of a depth with the relative variables to its couplings with the variables of
/// both keyframes.
TOLMAN_INLINE void ChunkSystem::couple(int target, const PairGeometry& pair, const Eight& by_depth,
                                       PointTerms& terms) const {
  Eight by_host{};
  for (std::size_t k = 0; k < kFrameVariables; ++k) {
    by_host += by_depth[k] * loadEight(pair.relative_by_host.data() + kFrameVariables * k);
  }
  const auto slot = static_cast<std::size_t>(target);
  add(by_depth, terms.coupling.data() + kFrameVariables * slot);
  add(by_host, terms.coupling.data() + kFrameVariables * static_cast<std::size_t>(host_));
  terms.slots |= (1U << slot) | (1U << static_cast<unsigned>(host_));
}

TOLMAN_WIDE_LANES void ChunkSystem::addStereo(const PixelSums& s, float focal_baseline,
                                              float lambda, const FieldTerms& by_field,
                                              PointTerms& terms) {
  const float xx = lambda * s.xx;
  const float xr = lambda * s.xr;
  terms.information += focal_baseline * focal_baseline * xx;
  terms.gradient -= focal_baseline * xr;
  coupleField(-focal_baseline * xx, by_field, terms);
  addToField(xx, xr, by_field);
  ++terms.good;
}

void ChunkSystem::eliminate(std::span<PointTerms> points) {
  constexpr float kMinInformation = 1e-3F;  // m^2; keeps the division finite
  for (PointTerms& point : points) {
    point.information += kMinInformation;
    point.coupling[kGradientIndex] = point.gradient;  // eliminated like one more variable
  }
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

/// Adds the Schur complement of four points, in the rows and columns of all variables that any of
/// the four is coupled with.
TOLMAN_WIDE_LANES void ChunkSystem::eliminateFour(const FourPoints& points) {
  constexpr std::size_t n = kFrameVariables;
  // The field and the gradient, which together have two groups of columns.
  constexpr std::uint32_t kLast = 3U << kSlots;
  std::array<const float*, 4> c{};
  std::array<float, 4> inverse{};
  std::uint32_t all = kLast;
  for (std::size_t p = 0; p < 4; ++p) {
    c[p] = points[p]->coupling.data();
    inverse[p] = 1.0F / points[p]->information;
    all |= points[p]->slots;
  }
  const auto addRow = [&](std::size_t i, std::uint32_t slots) TOLMAN_INLINE_LAMBDA {
    const Eight s0 = Eight{} + c[0][i] * inverse[0];
    const Eight s1 = Eight{} + c[1][i] * inverse[1];
    const Eight s2 = Eight{} + c[2][i] * inverse[2];
    const Eight s3 = Eight{} + c[3][i] * inverse[3];
    for (; slots != 0; slots &= slots - 1) {
      const std::size_t k = n * static_cast<std::size_t>(std::countr_zero(slots));
      add((s0 * loadEight(c[0] + k) + s1 * loadEight(c[1] + k)) +
              (s2 * loadEight(c[2] + k) + s3 * loadEight(c[3] + k)),
          schur_[i].data() + k);
    }
  };
  for (std::uint32_t slots = all; slots != kLast; slots &= slots - 1) {  // from first to last
    const std::size_t begin = n * static_cast<std::size_t>(std::countr_zero(slots));
    for (std::size_t i = begin; i < begin + n; ++i) addRow(i, slots);
  }
  for (std::size_t k = 0; k < kFields; ++k) addRow(kOffsetIndex + k, kLast);
}

float ChunkSystem::schurGradient(std::size_t i) const { return schur_[i][kGradientIndex]; }

}  // namespace tolman::direct_sparse
