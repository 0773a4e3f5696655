// SPDX-License-Identifier: BSD-3-Clause
// The residual pattern of a point, eight pixels, and the weights of its residuals (Engel et al.,
// PAMI 2018, section 2.2, figure 4 and equation 7). The constants are those of the paper.
#pragma once

#include <array>
#include <cmath>

namespace tolman::direct_sparse {

inline constexpr int kPatternSize = 8;
inline constexpr int kPatternRadius = 2;  // px
inline constexpr std::array<int, kPatternSize> kPatternU = {0, -1, 1, -2, 0, 2, -1, 0};
inline constexpr std::array<int, kPatternSize> kPatternV = {-2, -1, -1, 0, 0, 0, 1, 2};

inline constexpr float kHuber = 9;                 // grey levels
inline constexpr float kGradientConstant2 = 2500;  // c^2 of the gradient weight

/// Weight omega (equation 7): less weight for strong gradients, where geometric errors matter most.
inline float gradientWeight(float squared_gradient) {
  return kGradientConstant2 / (kGradientConstant2 + squared_gradient);
}

/// Weight of the Huber norm.
inline float huberWeight(float residual) {
  const float size = std::fabs(residual);
  return size <= kHuber ? 1.0F : kHuber / size;
}

/// Twice the Huber norm: the square for small residuals. `weight` is huberWeight(residual).
inline float huberEnergy(float residual, float weight) {
  return weight * (2.0F - weight) * residual * residual;
}

}  // namespace tolman::direct_sparse
