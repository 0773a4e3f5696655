// SPDX-License-Identifier: BSD-3-Clause
// Search along the row, and refinement to sub-pixel accuracy.
#include "static_stereo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>

#include "lanes.hpp"
#include "row_alignment.hpp"

namespace tolman::direct_sparse {

namespace {

constexpr int kRadius = 3;  // px, half side of the patch of the refinement; chosen, not tuned

/// The patch around (u, v), with the brightness of the other image.
TOLMAN_WIDE_LANES StereoPatch patchAround(const GrayLevel& image, int u, int v, float gain,
                                          float offset) {
  using Bytes = std::uint8_t __attribute__((vector_size(8)));
  static_assert(sizeof(Bytes) == kPatchWidth);
  StereoPatch patch;  // NOLINT: written before it is read
  std::uint8_t* out = patch.data();
  for (int y = 0; y < kPatchHeight; ++y, out += kPatchWidth) {
    const std::uint8_t* row = image.row(v + y - kPatchHeight / 2) + u - kPatchWidth / 2;
    const Eight value = gain * eightBytes(row) + offset;
    const EightInts rounded = truncated(clamped(value + 0.5F, 0, 255));
    const Bytes bytes = __builtin_convertvector(rounded, Bytes);
    std::memcpy(out, &bytes, sizeof bytes);
  }
  return patch;
}

struct RowMinimum {
  int u = 0;
  int best = std::numeric_limits<int>::max();
  int second = std::numeric_limits<int>::max();  ///< more than 2 px away from the best
};

TOLMAN_INLINE int leastOf(const std::uint16_t* begin, const std::uint16_t* end) {
  std::uint16_t least = std::numeric_limits<std::uint16_t>::max();
  for (; begin < end; ++begin) least = std::min(least, *begin);
  return least;
}

TOLMAN_WIDE_LANES RowMinimum searchRow(const StereoPatch& patch, const GrayLevel& image,
                                       int u_begin, int u_end, int v) {
  RowMinimum found;
  if (u_begin >= u_end) return found;
  std::array<std::uint16_t, kMaxDisparities + 8 + kMoreCosts> costs;  // NOLINT: written before read
  rowCosts(patch, image, u_begin, u_end, v, costs.data());
  const std::uint16_t* begin = costs.data();
  const std::uint16_t* end = begin + (u_end - u_begin);
  found.best = leastOf(begin, end);
  const std::uint16_t* best = std::find(begin, end, found.best);
  found.u = u_begin + static_cast<int>(best - begin);
  constexpr int kNear = 2;  // px
  const auto before = std::max<std::ptrdiff_t>(best - begin - kNear, 0);
  const auto behind = std::min<std::ptrdiff_t>(best - begin + kNear + 1, end - begin);
  if (before > 0) found.second = leastOf(begin, begin + before);
  if (begin + behind < end) found.second = std::min(found.second, leastOf(begin + behind, end));
  return found;
}

constexpr std::size_t kRefinedRows = kPatchHeight;
constexpr std::size_t kRefinedColumns = 2 * kRadius + 1;

/// The left patch of the refinement, with the brightness of the right image. Rows have an eighth
/// column that no sum uses.
struct LeftPatch {
  std::array<std::array<float, 8>, kRefinedRows> value;
  std::array<std::array<float, 8>, kRefinedRows> gradient;
  float gradients = 0;    ///< sum
  float information = 0;  ///< of a shift, with a brightness offset of the patch
};

constexpr float kRefinedPixels = kRefinedRows * kRefinedColumns;

TOLMAN_WIDE_LANES void fillPatch(const GrayLevel& left, int u, int v, float gain,
                                 LeftPatch& patch) {
  float squares = 0;
  for (std::size_t y = 0; y < kRefinedRows; ++y) {
    const std::uint8_t* l = left.row(v + static_cast<int>(y) - kPatchHeight / 2) + u - kRadius;
    store(gain * eightBytes(l), patch.value[y].data());
    store(0.5F * gain * differences(l + 1, l - 1), patch.gradient[y].data());
    for (std::size_t x = 0; x < kRefinedColumns; ++x) {
      const float g = patch.gradient[y][x];
      patch.gradients += g;
      squares += g * g;
    }
  }
  patch.information = squares - patch.gradients * patch.gradients / kRefinedPixels;
}

/// Catmull-Rom interpolation at p + 1 + f, and at the seven pixels after it.
TOLMAN_INLINE Eight cubic(const std::uint8_t* p, float f) {
  const Eight a = eightBytes(p);
  const Eight b = eightBytes(p + 1);
  const Eight c = eightBytes(p + 2);
  const Eight d = eightBytes(p + 3);
  return b + 0.5F * f * (c - a + f * (2 * a - 5 * b + 4 * c - d + f * (3 * (b - c) + d - a)));
}

struct StereoStep {
  float step = 0;  ///< px, to add to the column in the right image
  float rms = 0;   ///< grey levels, means removed
};

/// One Gauss-Newton step of the column in the right image, with a brightness offset of the patch.
/// Uses the derivative of the left image, which is the same in all iterations.
TOLMAN_WIDE_LANES StereoStep shiftOf(const LeftPatch& patch, const GrayLevel& right, int v,
                                     float u_right) {
  const int x_right = static_cast<int>(u_right);
  const float f = u_right - static_cast<float>(x_right);
  float sr = 0, sgr = 0, srr = 0;
  for (std::size_t y = 0; y < kRefinedRows; ++y) {
    const std::uint8_t* r =
        right.row(v + static_cast<int>(y) - kPatchHeight / 2) + x_right - kRadius - 1;
    const Eight e = cubic(r, f) - loadEight(patch.value[y].data());
    for (std::size_t x = 0; x < kRefinedColumns; ++x) {
      sr += e[x];
      sgr += patch.gradient[y][x] * e[x];
      srr += e[x] * e[x];
    }
  }
  const float gradient = sgr - patch.gradients * sr / kRefinedPixels;
  return {patch.information > 1 ? -gradient / patch.information : 0,
          std::sqrt(std::max(0.0F, (srr - sr * sr / kRefinedPixels) / kRefinedPixels))};
}

std::optional<StereoMatch> refine(const GrayLevel& left, const GrayLevel& right, int u, int v,
                                  int u_found, float gain) {
  constexpr float kMargin = kRadius + 2;
  // Chosen, not tuned.
  constexpr float kMinInformation = 300;  // a step of 18 grey levels in one pixel
  constexpr float kLargestRms = 14;       // grey levels
  auto u_right = static_cast<float>(u_found);
  LeftPatch patch;
  fillPatch(left, u, v, gain, patch);
  StereoStep shift;
  for (int i = 0; i < 6; ++i) {  // bounds the time
    if (!right.contains(u_right, static_cast<float>(v), kMargin - 2)) return std::nullopt;
    if (u_right < kMargin || u_right > static_cast<float>(right.width) - kMargin - 1) {
      return std::nullopt;
    }
    if (patch.information < kMinInformation) return std::nullopt;
    shift = shiftOf(patch, right, v, u_right);
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
  match.sigma = 0.05F + std::max(shift.rms, 2.0F) / std::sqrt(patch.information);
  return match;
}

}  // namespace

std::optional<StereoMatch> matchStereo(const GrayLevel& left, const GrayLevel& right, int u, int v,
                                       const StereoSearch& search) {
  constexpr float kMinRatio = 1.15F;  // of the second best cost to the best; chosen, not tuned
  constexpr int kLargestMiss = 1;     // px, of the search back; as in HorizonAD/stereo_dso
  constexpr int kBehind = 2;          // px below zero disparity, for the refinement of far points
  const int lowest = kStereoBorder;
  const int highest = right.width - kStereoBorder;
  const StereoPatch patch = patchAround(left, u, v, search.gain, search.offset);
  const int begin = std::max(lowest, u - search.max_disparity);
  const int end = std::min(highest, u + kBehind + 1);
  const RowMinimum forth = searchRow(patch, right, begin, end, v);
  const auto best = static_cast<float>(forth.best);
  constexpr float kNoise = 2 * kPatchWidth * kPatchHeight;  // makes two perfect matches ambiguous
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

namespace {

constexpr std::size_t kMaxCompared = 300;  // bounds the time
constexpr double kNearestPoint = 0.1;      // m; keeps the projection finite

/// A point of the window in the new frame: pixel and disparity, px.
struct Expected {
  int u = 0;
  int v = 0;
  double disparity = 0;
};

/// Empty for a point that static stereo cannot measure: behind the camera or at the border.
std::optional<Expected> expectedAt(const CameraRig& rig, const Eigen::Vector3d& position) {
  if (position.z() < kNearestPoint) return std::nullopt;
  const Eigen::Vector2d pixel = rig.pinhole.project(position);
  const auto inside = [](double x, int size) {
    return x >= kStereoBorder && x < size - kStereoBorder - 1;
  };
  if (!inside(pixel.x(), rig.width) || !inside(pixel.y(), rig.height)) return std::nullopt;
  return Expected{static_cast<int>(std::lround(pixel.x())),
                  static_cast<int>(std::lround(pixel.y())),
                  rig.pinhole.fx * rig.baseline / position.z()};
}

}  // namespace

StereoAgreement compareWithStereo(const CameraRig& rig, const Window& window,
                                  const Eigen::Isometry3d& T_world_camera, const GrayLevel& left,
                                  const GrayLevel& right, int max_disparity) {
  // Wide limits: a wrong place is wrong by metres. Moving objects and depth edges disagree at the
  // right place, too. Chosen as StereoAgreement::confirms().
  constexpr double kSlack = 1;     // px
  constexpr double kShare = 0.15;  // of the disparity
  StereoSearch search;
  search.max_disparity = max_disparity;
  balanceBrightness(left, right, search);
  StereoAgreement agreement;
  for (const Eigen::Vector3d& position :
       somePositions(rig.pinhole, window, T_world_camera.inverse(), kMaxCompared)) {
    const auto there = expectedAt(rig, position);
    if (!there) continue;
    const auto match = matchStereo(left, right, there->u, there->v, search);
    if (!match) continue;
    const auto disparity = static_cast<double>(match->disparity);
    const double measured = disparity + window.field.at(there->u - disparity, there->v, disparity);
    ++agreement.compared;
    const double error = std::fabs(measured - there->disparity);
    agreement.agreeing += error < kSlack + kShare * measured ? 1 : 0;
  }
  return agreement;
}

}  // namespace tolman::direct_sparse
