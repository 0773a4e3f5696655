// SPDX-License-Identifier: BSD-3-Clause
// Discrete search, Gauss-Newton along the line, and the update.
#include "epipolar_search.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tolman::direct_sparse {
namespace {

constexpr int kMaxSteps = 128;                 // px; bounds the time
constexpr float kMargin = kPatternRadius + 3;  // px; keeps reads within the image

/// The epipolar line: a point of inverse depth d projects to start + shift * d, dehomogenised.
struct Epipolar {
  Eigen::Vector3f start;
  Eigen::Vector3f shift;

  bool inFront(float d) const { return start.z() + shift.z() * d > 1e-3F; }
  Eigen::Vector2f pixel(float d) const {
    return (start.head<2>() + shift.head<2>() * d) / (start.z() + shift.z() * d);
  }
  /// Inverse depth of a pixel on the line, from the coordinate that changes more along it.
  float inverseDepth(const Eigen::Vector2f& p) const {
    const Eigen::Vector2f slope = shift.head<2>() - p * shift.z();
    const Eigen::Vector2f rest = p * start.z() - start.head<2>();
    return std::fabs(slope.x()) > std::fabs(slope.y()) ? rest.x() / slope.x()
                                                       : rest.y() / slope.y();
  }
};

/// The pattern as it appears in the frame: rotated, not scaled.
struct TurnedPattern {
  std::array<Eigen::Vector2f, kPatternSize> offsets;
  std::array<float, kPatternSize> expected;  ///< grey levels in the frame
};

TurnedPattern turned(const PairGeometry& pair, const ImmaturePoint& point, float z) {
  TurnedPattern pattern;
  Eigen::Matrix2f A;
  A << pair.warp[0], pair.warp[1], pair.warp[3], pair.warp[4];
  A /= z;
  for (std::size_t k = 0; k < kPatternSize; ++k) {
    pattern.offsets[k] =
        A * Eigen::Vector2f(static_cast<float>(kPatternU[k]), static_cast<float>(kPatternV[k]));
    pattern.expected[k] = pair.gain * (point.pattern.value[k] - pair.host_b) + pair.target_b;
  }
  return pattern;
}

float energyAt(const GrayLevel& image, const TurnedPattern& pattern, const Eigen::Vector2f& p) {
  float energy = 0;
  for (std::size_t k = 0; k < kPatternSize; ++k) {
    const Eigen::Vector2f q = p + pattern.offsets[k];
    const float r = image.at(q.x(), q.y()) - pattern.expected[k];
    energy += huberEnergy(r, huberWeight(r));
  }
  return energy;
}

struct LineFit {
  float shift = 0;  ///< px along the line
  float information = 0;
  float energy = 0;
};

LineFit fitAt(const GrayLevel& image, const TurnedPattern& pattern, const Eigen::Vector2f& p,
              const Eigen::Vector2f& along) {
  LineFit fit;
  float gradient = 0;
  for (std::size_t k = 0; k < kPatternSize; ++k) {
    const Eigen::Vector2f q = p + pattern.offsets[k];
    const float r = image.at(q.x(), q.y()) - pattern.expected[k];
    const Eigen::Vector2f ahead = q + 0.5F * along;
    const Eigen::Vector2f behind = q - 0.5F * along;
    const float g = image.at(ahead.x(), ahead.y()) - image.at(behind.x(), behind.y());
    const float w = huberWeight(r);
    fit.information += w * g * g;
    gradient += w * g * r;
    fit.energy += huberEnergy(r, w);
  }
  if (fit.information > 1) fit.shift = std::clamp(-gradient / fit.information, -0.7F, 0.7F);
  return fit;
}

struct Found {
  Eigen::Vector2f pixel;
  float quality = 0;
  bool inside = false;
};

Found searchLine(const GrayLevel& image, const TurnedPattern& pattern, const Eigen::Vector2f& from,
                 const Eigen::Vector2f& along, float length) {
  std::array<float, kMaxSteps> energies;  // NOLINT: written before it is read
  const int steps = std::min(static_cast<int>(std::ceil(length)) + 1, kMaxSteps);
  int best = -1;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2f p = from + static_cast<float>(i) * along;
    float& energy = energies[static_cast<std::size_t>(i)];
    energy = std::numeric_limits<float>::max();
    if (!image.contains(p.x(), p.y(), kMargin)) continue;
    energy = energyAt(image, pattern, p);
    if (best < 0 || energy < energies[static_cast<std::size_t>(best)]) best = i;
  }
  if (best < 0) return {};
  float second = std::numeric_limits<float>::max();
  for (int i = 0; i < steps; ++i) {
    if (std::abs(i - best) > 2) second = std::min(second, energies[static_cast<std::size_t>(i)]);
  }
  constexpr float kNoise = 50;  // makes two perfect matches ambiguous; chosen, not tuned
  const float ratio = (second + kNoise) / (energies[static_cast<std::size_t>(best)] + kNoise);
  return {from + static_cast<float>(best) * along, std::min(ratio, 100.0F), true};
}

/// Product of two Gaussians; a measurement that differs by more than three deviations is a failure.
void fuse(float measured, float sigma, ImmaturePoint& point) {
  if (!point.has_depth) {
    point.inverse_depth = measured;
    point.sigma = sigma;
    point.has_depth = true;
    return;
  }
  const float own = point.sigma * point.sigma;
  const float other = sigma * sigma;
  const float miss = measured - point.inverse_depth;
  if (miss * miss > 9 * (own + other)) {
    ++point.failures;
    return;
  }
  point.inverse_depth = (point.inverse_depth * other + measured * own) / (own + other);
  point.sigma = std::sqrt(own * other / (own + other));
  point.failures = std::max(0, point.failures - 1);
}

}  // namespace

void observeImmature(const PairGeometry& pair, const GrayLevel& image,
                     const EpipolarSettings& settings, ImmaturePoint& point) {
  constexpr float kWorthwhile = 1.5F;  // px; as in DSO (Engel et al.)
  const auto& m = pair.warp;
  const Epipolar line{
      {m[0] * point.u + m[1] * point.v + m[2], m[3] * point.u + m[4] * point.v + m[5],
       m[6] * point.u + m[7] * point.v + m[8]},
      {pair.shift[0], pair.shift[1], pair.shift[2]}};
  const float reach = 2 * point.sigma;
  const float low = point.has_depth ? std::max(point.inverse_depth - reach, 1e-5F) : 1e-5F;
  // Skips depths at which the point would be five times nearer to the frame than to the host
  // (chosen, not tuned).
  constexpr float kNearest = 0.2F;
  const float ahead_limit = line.shift.z() < 0
                                ? (kNearest * line.start.z() - line.start.z()) / line.shift.z()
                                : settings.largest_inverse_depth;
  const float wanted =
      point.has_depth ? point.inverse_depth + reach : settings.largest_inverse_depth;
  const float high = std::min(wanted, ahead_limit);
  if (!(high > low) || !line.inFront(low) || !line.inFront(high)) return;
  const Eigen::Vector2f from = line.pixel(low);
  const Eigen::Vector2f way = line.pixel(high) - from;
  const float length = way.norm();
  point.last_interval = length;
  if (!(length > kWorthwhile)) return;
  if (!image.contains(from.x(), from.y(), kMargin)) return;

  const Eigen::Vector2f along = way / length;
  const TurnedPattern pattern = turned(pair, point, line.start.z());
  const Found found = searchLine(image, pattern, from, along, std::min(length, settings.longest));
  if (!found.inside) return;
  Eigen::Vector2f p = found.pixel;
  LineFit fit;
  for (int i = 0; i < 3; ++i) {  // steps; as in DSO
    if (!image.contains(p.x(), p.y(), kMargin)) return;
    fit = fitAt(image, pattern, p, along);
    p += fit.shift * along;
    if (std::fabs(fit.shift) < 0.05F) break;  // px; chosen, not tuned
  }
  float gradients = 1;  // sum of squared gradients of the pattern in the host
  for (const float weight : point.pattern.weight) {
    gradients += kGradientConstant2 * (1 / weight - 1);
  }
  constexpr float kMaxEnergy = 12 * 12 * kPatternSize;  // as Window::kFirstThreshold
  if (fit.energy > kMaxEnergy || fit.information < 0.05F * gradients) {
    ++point.failures;
    return;
  }
  // Position error along the line, px, from the direction error of the line and from image noise;
  // the constants are those of DSO.
  const float error = std::min(0.2F + 0.2F * gradients / fit.information, 10.0F);
  const float measured = line.inverseDepth(p);
  const float ahead = line.inverseDepth(p + error * along);
  if (!std::isfinite(measured) || !std::isfinite(ahead)) return;
  point.quality = found.quality;
  // Ratio of the second best energy to the best: chosen, not tuned.
  if (found.quality < 1.2F || measured < -std::fabs(ahead - measured)) {
    ++point.failures;
    return;
  }
  fuse(std::max(measured, 1e-5F), std::max(std::fabs(ahead - measured), 1e-6F), point);
}

}  // namespace tolman::direct_sparse
