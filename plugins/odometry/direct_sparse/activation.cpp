// SPDX-License-Identifier: BSD-3-Clause
// Adaptation of the spacing, refinement in parallel, and insertion into the window.
#include "activation.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace tolman::direct_sparse {
namespace {

struct Landing {
  bool inside = false;
  float u = 0;
  float v = 0;
};

Landing land(const PairGeometry& pair, const GrayLevel& image, float u, float v, float d) {
  const auto& m = pair.warp;
  const float z = m[6] * u + m[7] * v + m[8] + pair.shift[2] * d;
  if (!(z > 1e-3F)) return {};  // of the host's depth; keeps the division finite
  const float x = (m[0] * u + m[1] * v + m[2] + pair.shift[0] * d) / z;
  const float y = (m[3] * u + m[4] * v + m[5] + pair.shift[1] * d) / z;
  return {image.contains(x, y, kPatternRadius + 1), x, y};
}

constexpr int kGone = 1000;  // failures: marks a candidate for removal

enum class Readiness { Ready, Wait, Hopeless };

Readiness readiness(const ImmaturePoint& point) {
  // Chosen on clip 06. The refinement linearises in the inverse depth and converges from errors of
  // about a fifth. Far points never have this relative accuracy; for them 0.01 1/m is enough. A
  // candidate that three epipolar searches have not found is occluded or on repeated texture.
  constexpr int kMaxFailures = 3;
  constexpr float kLargestRelativeSigma = 0.2F;
  constexpr float kFarSigma = 0.01F;  // 1/m
  if (point.failures >= kMaxFailures) return Readiness::Hopeless;
  const bool sharp = point.sigma < kLargestRelativeSigma * point.inverse_depth + kFarSigma;
  return point.has_depth && sharp ? Readiness::Ready : Readiness::Wait;
}

/// Sums of the residuals of a candidate, for a step of its inverse depth.
struct DepthSums {
  float information = 1e-3F;  ///< m^2; keeps the division finite
  float gradient = 0;
  int good = 0;  ///< keyframes
  int seen = 0;
};

/// The residuals in the other keyframes; sets their states.
DepthSums temporalDepthSums(const CameraRig& rig, const Window& window, int host,
                            const std::vector<PairGeometry>& pairs, Point& point) {
  const auto pairWith = [&](int target) -> const PairGeometry& {
    return pairs[indexOfSlot(host * kSlots + target)];
  };
  std::array<PatternPlaces, kSlots> places;
  for (const int target : window.order()) {
    if (target == host) continue;
    placePattern(pairWith(target), window.keyframe(target).left.level(0), point,
                 places[indexOfSlot(target)]);
  }
  DepthSums depth;
  for (const int target : window.order()) {
    if (target == host) continue;
    ResidualState& state = point.temporal[indexOfSlot(target)];
    state = ResidualState::Absent;
    const PatternPlaces& place = places[indexOfSlot(target)];
    if (!place.inside) continue;
    ++depth.seen;
    const PairGeometry& pair = pairWith(target);
    const PixelSums sums =
        temporalSums(pair, window.keyframe(target).left.level(0), point.pattern, place);
    if (sums.energy > window.energy_threshold) continue;
    const CentreJacobian J =
        centreJacobian(rig.pinhole, pair, point.u, point.v, point.inverse_depth);
    const float ju = J.u_by_depth;
    const float jv = J.v_by_depth;
    depth.information += ju * ju * sums.xx + 2 * ju * jv * sums.xy + jv * jv * sums.yy;
    depth.gradient += ju * sums.xr + jv * sums.yr;
    state = ResidualState::Good;
    ++depth.good;
  }
  return depth;
}

}  // namespace

void Occupancy::reset(int width, int height, float spacing) {
  spacing_ = std::max(spacing, 1.0F);
  columns_ = static_cast<int>(static_cast<float>(width) / spacing_) + 1;
  rows_ = static_cast<int>(static_cast<float>(height) / spacing_) + 1;
  cells_.assign(static_cast<std::size_t>(columns_ * rows_), Cell());
}

bool Occupancy::claim(float u, float v) {
  const int column = static_cast<int>(u / spacing_);
  const int row = static_cast<int>(v / spacing_);
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
      const Cell& cell = cells_[indexOfSlot(r * columns_ + c)];
      const float du = cell.u - u;
      const float dv = cell.v - v;
      if (du * du + dv * dv < spacing_ * spacing_) return false;
    }
  }
  cells_[indexOfSlot(row * columns_ + column)] = {u, v};
  return true;
}

std::optional<Point> refineCandidate(const CameraRig& rig, const SystemSettings& settings,
                                     const Window& window, int host,
                                     const std::vector<PairGeometry>& pairs,
                                     const ImmaturePoint& candidate) {
  // Both values are those of Engel et al. 2018 (DSO). For residuals with a noise of one grey level
  // an information of 100 m^2 is a standard deviation of the inverse depth of 0.1 1/m.
  constexpr int kIterations = 3;
  constexpr float kMinInformation = 100;  // m^2
  const Keyframe& keyframe = window.keyframe(host);
  Point point;
  point.u = candidate.u;
  point.v = candidate.v;
  point.pattern = candidate.pattern;
  point.inverse_depth = std::max(candidate.inverse_depth, 1e-5F);  // 1/m; stays in front
  StereoGeometry stereo{static_cast<float>(rig.pinhole.fx * rig.baseline), 0, keyframe.right_gain,
                        keyframe.right_offset};
  const float disparity = stereo.focal_baseline * point.inverse_depth;
  stereo.offset = static_cast<float>(window.field.at(static_cast<double>(point.u - disparity),
                                                     point.v, static_cast<double>(disparity)));
  const bool use_stereo = keyframe.has_right && settings.lambda > 0;
  for (int i = 0; i < kIterations; ++i) {
    auto [information, gradient, good, seen] = temporalDepthSums(rig, window, host, pairs, point);
    point.stereo = ResidualState::Absent;
    PixelSums sums;
    if (use_stereo && stereoSums(stereo, keyframe.right.level(0), point, sums) &&
        sums.energy <= window.energy_threshold) {
      information += settings.lambda * stereo.focal_baseline * stereo.focal_baseline * sums.xx;
      gradient -= settings.lambda * stereo.focal_baseline * sums.xr;
      point.stereo = ResidualState::Good;
    }
    // A point that projects into no other keyframe needs only its residual in the right image.
    const bool right_only = seen == 0 && keyframe.has_right;
    if (right_only && settings.lambda == 0) return point;  // it has no residual to refine it with
    const bool enough = good > 0 || (right_only && point.stereo == ResidualState::Good);
    if (!enough || information < kMinInformation) return std::nullopt;
    // Limits a step to a little more than the initial error of a candidate (see readiness()).
    const float limit = 0.3F * point.inverse_depth + 0.01F;
    const float step = std::clamp(-gradient / information, -limit, limit);
    point.inverse_depth = std::max(point.inverse_depth + step, 1e-5F);
    point.information = information;
    if (std::fabs(step) < 4e-3F * point.inverse_depth) break;  // chosen, not tuned
  }
  return point;
}

// Sequential placing at random of points at least s apart ends when discs of diameter s cover about
// 0.55 of the area. The factor 0.6 of the first spacing gives about the wanted number. From
// keyframe to keyframe the spacing changes by a fifth at most, so that one view with little texture
// has little influence. It stays between 2 and 40 px (chosen, not tuned).
void Activator::adaptSpacing(const CameraRig& rig, int wanted) {
  if (spacing_ == 0) {
    spacing_ = static_cast<float>(
        0.6 * std::sqrt(static_cast<double>(rig.width) * rig.height / static_cast<double>(wanted)));
  }
  const double ratio = static_cast<double>(last_count_) / wanted;
  if (last_count_ > 0) spacing_ *= static_cast<float>(std::clamp(ratio, 0.8, 1.25));
  spacing_ = std::clamp(spacing_, 2.0F, 40.0F);
}

void Activator::chooseFrom(int host, Window& window, const PairGeometry* to_newest) {
  const GrayLevel& newest = window.newest().left.level(0);
  std::vector<ImmaturePoint>& immature = window.keyframe(host).immature;
  for (std::size_t i = 0; i < immature.size(); ++i) {
    ImmaturePoint& point = immature[i];
    Landing place{true, point.u, point.v};
    if (to_newest != nullptr) {
      place = land(*to_newest, newest, point.u, point.v, point.inverse_depth);
    }
    if (!place.inside) point.failures = kGone;
    if (readiness(point) != Readiness::Ready || !occupancy_.claim(place.u, place.v)) continue;
    chosen_.push_back({host, i});
  }
}

void Activator::activate(const CameraRig& rig, const SystemSettings& settings, int wanted,
                         Window& window) {
  const int newest = window.newestSlot();
  adaptSpacing(rig, wanted);
  occupancy_.reset(rig.width, rig.height, spacing_);
  pairs_.resize(kSlots * kSlots);
  for (const int host : window.order()) {
    for (const int target : window.order()) {
      if (host == target) continue;
      pairs_[indexOfSlot(host * kSlots + target)] =
          pairGeometry(rig.pinhole, window.keyframe(host), window.keyframe(target));
    }
    if (host == newest) continue;
    const PairGeometry& pair = pairs_[indexOfSlot(host * kSlots + newest)];
    for (Point& point : window.keyframe(host).points) {
      point.temporal[indexOfSlot(newest)] = ResidualState::Good;
      const Landing place =
          land(pair, window.newest().left.level(0), point.u, point.v, point.inverse_depth);
      if (place.inside) occupancy_.claim(place.u, place.v);
    }
  }
  chosen_.clear();
  for (const int host : window.order()) {
    chooseFrom(host, window,
               host == newest ? nullptr : &pairs_[indexOfSlot(host * kSlots + newest)]);
  }
  refined_.assign(chosen_.size(), std::nullopt);
  tbb::parallel_for(std::size_t{0}, chosen_.size(), [&](std::size_t i) {
    const ImmaturePoint& candidate = window.keyframe(chosen_[i].host).immature[chosen_[i].index];
    refined_[i] = refineCandidate(rig, settings, window, chosen_[i].host, pairs_, candidate);
  });
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    Keyframe& keyframe = window.keyframe(chosen_[i].host);
    keyframe.immature[chosen_[i].index].failures = kGone;  // activated, or wrong
    if (!refined_[i]) continue;
    keyframe.points.push_back(*refined_[i]);
    ++keyframe.points_made;
  }
  for (const int host : window.order()) {
    std::erase_if(window.keyframe(host).immature, [](const ImmaturePoint& point) {
      return readiness(point) == Readiness::Hopeless;
    });
  }
  last_count_ = window.pointCount();
}

}  // namespace tolman::direct_sparse
