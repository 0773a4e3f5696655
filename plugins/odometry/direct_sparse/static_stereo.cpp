// SPDX-License-Identifier: BSD-3-Clause
// Row search and refinement.
#include "static_stereo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace tolman::direct_sparse {
namespace {

// The sizes of the patches are chosen, not tuned.
constexpr int kWidth = 8;   // px of the patch; columns -4 ... 3 around the pixel
constexpr int kHeight = 5;  // px
constexpr int kRadius = 3;  // px, half side of the patch of the refinement

using StereoPatch = std::array<std::uint8_t, kWidth*(kHeight + 1)>;  // the sixth row stays zero

/// The patch around (u, v), with the brightness of the other image.
StereoPatch patchAround(const GrayLevel& image, int u, int v, float gain, float offset) {
  StereoPatch patch{};
  for (int y = 0; y < kHeight; ++y) {
    const std::uint8_t* row = image.row(v + y - kHeight / 2) + u - kWidth / 2;
    for (int x = 0; x < kWidth; ++x) {
      const float value = gain * static_cast<float>(row[x]) + offset;
      patch[static_cast<std::size_t>(y * kWidth + x)] =
          static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
    }
  }
  return patch;
}

/// Sum of absolute differences between the patch and the image around (u, v).
#if defined(__SSE2__)
__m128i twoRows(const std::uint8_t* a, const std::uint8_t* b) {
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(a));
  const __m128i high = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(b));
  return _mm_unpacklo_epi64(low, high);
}

int difference(const StereoPatch& patch, const GrayLevel& image, int u, int v) {
  const std::uint8_t* p = image.row(v - kHeight / 2) + u - kWidth / 2;
  const std::ptrdiff_t w = image.width;
  const auto* mine = reinterpret_cast<const __m128i*>(patch.data());
  const __m128i zero = _mm_setzero_si128();
  const __m128i last = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(p + 4 * w));
  __m128i sum = _mm_sad_epu8(_mm_loadu_si128(mine), twoRows(p, p + w));
  sum = _mm_add_epi64(sum, _mm_sad_epu8(_mm_loadu_si128(mine + 1), twoRows(p + 2 * w, p + 3 * w)));
  sum = _mm_add_epi64(sum, _mm_sad_epu8(_mm_loadu_si128(mine + 2), _mm_unpacklo_epi64(last, zero)));
  return _mm_cvtsi128_si32(sum) + _mm_cvtsi128_si32(_mm_unpackhi_epi64(sum, sum));
}
#else
int difference(const StereoPatch& patch, const GrayLevel& image, int u, int v) {
  int sum = 0;
  for (int y = 0; y < kHeight; ++y) {
    const std::uint8_t* row = image.row(v + y - kHeight / 2) + u - kWidth / 2;
    for (int x = 0; x < kWidth; ++x) {
      sum += std::abs(row[x] - patch[static_cast<std::size_t>(y * kWidth + x)]);
    }
  }
  return sum;
}
#endif

struct RowMinimum {
  int u = 0;
  int best = std::numeric_limits<int>::max();
  int second = std::numeric_limits<int>::max();  ///< more than 2 px away from the best
};

RowMinimum searchRow(const StereoPatch& patch, const GrayLevel& image, int u_begin, int u_end,
                     int v) {
  RowMinimum found;
  std::array<int, kMaxDisparities + 8> costs;  // NOLINT: written before it is read
  for (int u = u_begin; u < u_end; ++u) {
    const int cost = difference(patch, image, u, v);
    costs[static_cast<std::size_t>(u - u_begin)] = cost;
    if (cost >= found.best) continue;
    found.best = cost;
    found.u = u;
  }
  for (int u = u_begin; u < u_end; ++u) {
    if (std::abs(u - found.u) > 2) {
      found.second = std::min(found.second, costs[static_cast<std::size_t>(u - u_begin)]);
    }
  }
  return found;
}

/// Value between p[1] and p[2] by Catmull-Rom; `p` points one pixel to the left.
float cubic(const std::uint8_t* p, float f) {
  const auto a = static_cast<float>(p[0]);
  const auto b = static_cast<float>(p[1]);
  const auto c = static_cast<float>(p[2]);
  const auto d = static_cast<float>(p[3]);
  return b + 0.5F * f * (c - a + f * (2 * a - 5 * b + 4 * c - d + f * (3 * (b - c) + d - a)));
}

struct StereoStep {
  float step = 0;  ///< px, to add to the right pixel
  float information = 0;
  float rms = 0;  ///< grey levels, means removed
};

/// One Gauss-Newton step of the right pixel, with a brightness offset of the patch. Uses the
/// derivative of the left image, which is the same in all iterations.
StereoStep shiftOf(const GrayLevel& left, const GrayLevel& right, int u, int v, float u_right,
                   float gain) {
  const int x = static_cast<int>(u_right);
  const float f = u_right - static_cast<float>(x);
  float sg = 0, sr = 0, sgg = 0, sgr = 0, srr = 0;
  constexpr float n = (2 * kRadius + 1) * kHeight;
  for (int dy = -kHeight / 2; dy <= kHeight / 2; ++dy) {
    const std::uint8_t* l = left.row(v + dy) + u;
    const std::uint8_t* r = right.row(v + dy) + x;
    for (int dx = -kRadius; dx <= kRadius; ++dx) {
      const float g = 0.5F * gain * static_cast<float>(l[dx + 1] - l[dx - 1]);
      const float e = cubic(r + dx - 1, f) - gain * static_cast<float>(l[dx]);
      sg += g;
      sr += e;
      sgg += g * g;
      sgr += g * e;
      srr += e * e;
    }
  }
  const float information = sgg - sg * sg / n;
  const float gradient = sgr - sg * sr / n;
  return {information > 1 ? -gradient / information : 0, information,
          std::sqrt(std::max(0.0F, (srr - sr * sr / n) / n))};
}

std::optional<StereoMatch> refine(const GrayLevel& left, const GrayLevel& right, int u, int v,
                                  int u_found, float gain) {
  constexpr float kMargin = kRadius + 2;
  // Chosen, not tuned.
  constexpr float kMinInformation = 300;  // a step of 18 grey levels in one pixel
  constexpr float kLargestRms = 14;       // grey levels
  auto u_right = static_cast<float>(u_found);
  StereoStep shift;
  for (int i = 0; i < 6; ++i) {  // bounds the time
    if (!right.contains(u_right, static_cast<float>(v), kMargin - 2)) return std::nullopt;
    if (u_right < kMargin || u_right > static_cast<float>(right.width) - kMargin - 1) {
      return std::nullopt;
    }
    shift = shiftOf(left, right, u, v, u_right, gain);
    if (shift.information < kMinInformation) return std::nullopt;
    u_right += std::clamp(shift.step, -0.7F, 0.7F);
    if (std::fabs(shift.step) < 0.005F) break;  // px; chosen, not tuned
  }
  if (std::fabs(u_right - static_cast<float>(u_found)) > 1.5F || shift.rms > kLargestRms) {
    return std::nullopt;
  }
  StereoMatch match;
  match.disparity = static_cast<float>(u) - u_right;
  // Standard deviation from grey level noise, plus 0.05 px for depths that differ within the patch.
  // 0.05 px and the least noise of 2 grey levels are chosen, not tuned.
  match.sigma = 0.05F + std::max(shift.rms, 2.0F) / std::sqrt(shift.information);
  return match;
}

}  // namespace

std::optional<StereoMatch> matchStereo(const GrayLevel& left, const GrayLevel& right, int u, int v,
                                       const StereoSearch& search) {
  constexpr float kMinRatio = 1.15F;  // of the second best cost to the best; chosen, not tuned
  constexpr int kLargestMiss = 1;     // px, from right to left; as in HorizonAD/stereo_dso
  constexpr int kBehind = 2;          // px below zero disparity, for the refinement of far points
  const int lowest = kStereoBorder;
  const int highest = right.width - kStereoBorder;
  const StereoPatch patch = patchAround(left, u, v, search.gain, search.offset);
  const int begin = std::max(lowest, u - search.max_disparity);
  const int end = std::min(highest, u + kBehind + 1);
  const RowMinimum forth = searchRow(patch, right, begin, end, v);
  const auto best = static_cast<float>(forth.best);
  constexpr float kNoise = 2 * kWidth * kHeight;  // makes two perfect matches ambiguous
  const float quality = (static_cast<float>(forth.second) + kNoise) / (best + kNoise);
  if (forth.best == std::numeric_limits<int>::max() || quality < kMinRatio) return std::nullopt;

  const float inverse_gain = 1.0F / std::max(search.gain, 0.05F);  // keeps the division finite
  const StereoPatch back_patch =
      patchAround(right, forth.u, v, inverse_gain, -search.offset * inverse_gain);
  const RowMinimum back = searchRow(back_patch, left, std::max(lowest, forth.u - kBehind),
                                    std::min(highest, forth.u + search.max_disparity + 1), v);
  if (std::abs(back.u - u) > kLargestMiss) return std::nullopt;

  std::optional<StereoMatch> match = refine(left, right, u, v, forth.u, search.gain);
  if (match) match->quality = quality;
  return match;
}

void balanceBrightness(const GrayLevel& left, const GrayLevel& right, StereoSearch& search) {
  const GrayStatistics l = grayStatistics(left);
  const GrayStatistics r = grayStatistics(right);
  search.gain = std::clamp(r.deviation / std::max(l.deviation, 1.0F), 0.3F, 3.0F);
  search.offset = r.mean - search.gain * l.mean;
}

}  // namespace tolman::direct_sparse
