// SPDX-License-Identifier: BSD-3-Clause
#include "patch_match.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::direct_sparse {
namespace {

constexpr int kMostPixels = (2 * kLargestPatchRadius + 1) * (2 * kLargestPatchRadius + 1);
using Values = Eigen::Array<float, Eigen::Dynamic, 1, 0, kMostPixels, 1>;

/// Grey values and gradients of the patch, means removed.
struct Patch {
  int radius = 0;
  Values value, gu, gv;
  float guu = 0, guv = 0, gvv = 0;

  float smallestEigenvalue() const {
    const float half = 0.5F * (guu - gvv);
    return 0.5F * (guu + gvv) - std::sqrt(half * half + guv * guv);
  }
};

Patch patchAt(const GrayLevel& image, int u, int v, float gain, int radius) {
  const int pixels = (2 * radius + 1) * (2 * radius + 1);
  Patch patch{radius, Values(pixels), Values(pixels), Values(pixels)};
  int k = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    const std::uint8_t* row = image.row(v + dy) + u;
    for (int dx = -radius; dx <= radius; ++dx, ++k) {
      const std::uint8_t* p = row + dx;
      patch.value[k] = gain * static_cast<float>(*p);
      patch.gu[k] = 0.5F * gain * static_cast<float>(p[1] - p[-1]);
      patch.gv[k] = 0.5F * gain * static_cast<float>(p[image.width] - p[-image.width]);
    }
  }
  patch.value -= patch.value.mean();
  patch.gu -= patch.gu.mean();
  patch.gv -= patch.gv.mean();
  patch.guu = patch.gu.square().sum();
  patch.guv = (patch.gu * patch.gv).sum();
  patch.gvv = patch.gv.square().sum();
  return patch;
}

/// Differences of the image around `at` from the patch, means removed.
Values differences(const Patch& patch, const GrayLevel& image, const Eigen::Vector2f& at) {
  const int x = static_cast<int>(at.x());
  const int y = static_cast<int>(at.y());
  const float fx = at.x() - static_cast<float>(x);
  const float fy = at.y() - static_cast<float>(y);
  const int radius = patch.radius;
  Values e(patch.value.size());
  int k = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    const std::uint8_t* p = image.row(y + dy) + x;
    const std::uint8_t* q = p + image.width;
    for (int dx = -radius; dx <= radius; ++dx, ++k) {
      const auto p0 = static_cast<float>(p[dx]), q0 = static_cast<float>(q[dx]);
      const float top = p0 + fx * (static_cast<float>(p[dx + 1]) - p0);
      const float bottom = q0 + fx * (static_cast<float>(q[dx + 1]) - q0);
      e[k] = top + fy * (bottom - top);
    }
  }
  e -= e.mean();
  return e - patch.value;
}

}  // namespace

std::optional<Eigen::Vector2f> matchPatch(const GrayLevel& here, int u, int v,
                                          const GrayLevel& there, const Eigen::Vector2f& start,
                                          float gain, int radius) {
  // Chosen, not tuned.
  constexpr float kMinInformation = 25;      // smallest eigenvalue a pixel, grey levels^2
  constexpr float kLargestMeanSquare = 100;  // grey levels^2
  constexpr float kFarthest = 1.5F;          // px
  const float margin = static_cast<float>(radius + 1);
  constexpr int kSteps = 8;
  if (!here.contains(static_cast<float>(u), static_cast<float>(v), margin)) return {};
  const Patch patch = patchAt(here, u, v, gain, radius);
  if (patch.smallestEigenvalue() < kMinInformation * static_cast<float>(patch.value.size()))
    return {};
  const float determinant = patch.guu * patch.gvv - patch.guv * patch.guv;
  Eigen::Vector2f at = start;
  for (int step = 0; step < kSteps; ++step) {
    if (!there.contains(at.x(), at.y(), margin)) return {};
    const auto e = differences(patch, there, at);
    const float eu = (patch.gu * e).sum();
    const float ev = (patch.gv * e).sum();
    const Eigen::Vector2f change((patch.guv * ev - patch.gvv * eu) / determinant,
                                 (patch.guv * eu - patch.guu * ev) / determinant);
    at += change.cwiseMax(-0.7F).cwiseMin(0.7F);
    if ((at - start).cwiseAbs().maxCoeff() > kFarthest) return {};
    if (change.cwiseAbs().maxCoeff() < 0.01F) {
      if (e.square().mean() > kLargestMeanSquare) return {};
      return at;
    }
  }
  return {};
}

}  // namespace tolman::direct_sparse
