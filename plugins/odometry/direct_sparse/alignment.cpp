// SPDX-License-Identifier: BSD-3-Clause
// Levenberg-Marquardt over pose and brightness, eight samples at a time (SIMD).
#include "alignment.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "gradient_samples.hpp"

namespace tolman::direct_sparse {
namespace {

constexpr std::size_t kLanes = ReferenceLevel::kGroup;
constexpr std::size_t kGroupsPerChunk = 128;  // fixed, for the same sums with any thread count
// Grey levels; larger residuals are outliers. The value of DSO (Engel et al.)
constexpr float kCutoff = 20;
// At most, by level. Chosen, not tuned; they bound the time.
constexpr std::array<int, ImagePyramid::kMaxLevels> kIterations = {8, 12, 30, 30, 30, 30};

/// T_current_reference and the camera of one level, in float.
struct LevelView {
  std::array<float, 9> R;
  std::array<float, 3> t;
  float fx, fy, cx, cy;
  float gain, offset;
};

constexpr double kLargestFlow = 0.06;  // share of width + height; 97 px on KITTI; chosen, not tuned

/// Grid over the image that records which parts have samples.
class CoverageGrid {
 public:
  explicit CoverageGrid(const CameraRig& rig) : rig_(rig) {}
  void add(const Eigen::Vector3d& ray) {
    const Eigen::Vector2d pixel = rig_.pinhole.project(ray);
    const double column = pixel.x() / rig_.width * kColumns;
    const double row = pixel.y() / rig_.height * kRows;
    if (!(column >= 0 && column < kColumns && row >= 0 && row < kRows)) return;
    bool& cell =
        taken_[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
    count_ += cell ? 0 : 1;
    cell = true;
  }
  int taken() const { return count_; }

 private:
  static constexpr int kColumns = 16;  // cells; chosen, not tuned
  static constexpr int kRows = 8;      // cells; chosen, not tuned
  const CameraRig& rig_;
  std::array<bool, kColumns * kRows> taken_{};
  int count_ = 0;
};

LevelView levelView(const CameraRig& rig, int l, const AlignmentState& state) {
  LevelView view{};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      view.R[static_cast<std::size_t>(3 * r + c)] =
          static_cast<float>(state.T_current_reference.linear()(r, c));
    }
    view.t[static_cast<std::size_t>(r)] =
        static_cast<float>(state.T_current_reference.translation()[r]);
  }
  const float scale = 1.0F / static_cast<float>(1 << l);
  view.fx = static_cast<float>(rig.pinhole.fx) * scale;
  view.fy = static_cast<float>(rig.pinhole.fy) * scale;
  view.cx = toLevel(static_cast<float>(rig.pinhole.cx), l);
  view.cy = toLevel(static_cast<float>(rig.pinhole.cy), l);
  view.gain = static_cast<float>(std::exp(state.brightness.a));
  view.offset = static_cast<float>(state.brightness.b);
  return view;
}

/// Eight samples projected into the image.
struct Seen {
  Eight grey;
  Eight weight;  ///< 0 out of view; such samples read the pixel (1, 1)
};

TOLMAN_INLINE Seen see(const LevelView& view, const ReferenceLevel& level, const GrayLevel& image,
                       std::size_t first) {
  const Eight x = loadEight(level.x.data() + first);
  const Eight y = loadEight(level.y.data() + first);
  const Eight d = loadEight(level.d.data() + first);
  const Eight z = view.R[6] * x + view.R[7] * y + view.R[8] + view.t[2] * d;
  const Eight inverse = 1.0F / z;
  const Eight px = view.R[0] * x + view.R[1] * y + view.R[2] + view.t[0] * d;
  const Eight py = view.R[3] * x + view.R[4] * y + view.R[5] + view.t[1] * d;
  const Eight u = view.fx * px * inverse + view.cx;
  const Eight v = view.fy * py * inverse + view.cy;
  const float right = static_cast<float>(image.width) - 2.0F;
  const float bottom = static_cast<float>(image.height) - 2.0F;
  const EightInts seen = (z > 1e-3F) & (u >= 1.0F) & (v >= 1.0F) & (u < right) & (v < bottom);
  const Eight one = Eight{} + 1.0F;
  const Eight weight = loadEight(level.weight.data() + first);
  return {bilinear(image, seen ? u : one, seen ? v : one), seen ? weight : Eight{}};
}

/// Running sums of each lane.
using LaneSums = std::array<Eight, Aligner::kSums>;

/// Adds eight samples.
TOLMAN_INLINE void addSamples(const LevelView& view, const ReferenceLevel& level, std::size_t first,
                              const Seen& sample, float cutoff, bool with_H, LaneSums& sums) {
  constexpr std::size_t n = Aligner::kSums - 4;
  const Eight zero{};
  const Eight one = zero + 1.0F;
  const Eight scene = view.gain * loadEight(level.value.data() + first);
  const Eight r = sample.grey - scene - view.offset;
  const Eight size = absolute(r);
  const Eight in = size < cutoff ? one : zero;
  const Eight capped = size < cutoff ? size : zero + cutoff;
  const Eight huber = size <= kHuber ? one : kHuber / size;
  const Eight capped_huber = capped <= kHuber ? one : kHuber / capped;
  const Eight seen = sample.weight > 0.0F ? one : zero;
  sums[n] += sample.weight * capped_huber * (2.0F - capped_huber) * capped * capped;
  sums[n + 1] += seen * capped * capped;
  sums[n + 2] += seen * in;
  sums[n + 3] += seen;
  const Eight w = in * sample.weight * huber;
  std::array<Eight, Aligner::kColumns> column;
  for (std::size_t i = 0; i < 6; ++i) {
    column[i] = -view.gain * loadEight(level.by_twist[i].data() + first);
  }
  column[6] = -scene;
  column[7] = -one;
  column[8] = r;
  std::size_t s = 0;
  for (std::size_t i = 0; i < column.size(); ++i) {
    const Eight wi = w * column[i];
    const std::size_t skipped = with_H ? 0 : column.size() - 1 - i;
    s += skipped;
    for (std::size_t j = i + skipped; j < column.size(); ++j, ++s) sums[s] += wi * column[j];
  }
}

}  // namespace

TOLMAN_WIDE_LANES void Aligner::sumChunk(const CameraRig& rig, const ReferenceLevel& level,
                                         const GrayLevel& image, int l, const AlignmentState& state,
                                         float cutoff, Sought sought, std::size_t begin,
                                         std::size_t end, Sums& sums) {
  const LevelView view = levelView(rig, l, state);
  LaneSums lanes{};
  for (std::size_t group = begin; group < end; ++group) {
    const std::size_t first = group * kLanes;
    const Seen sample = see(view, level, image, first);
    if (sought == Sought::GradientAndH) {
      addSamples(view, level, first, sample, cutoff, true, lanes);
    } else {
      addSamples(view, level, first, sample, cutoff, false, lanes);
    }
  }
  for (std::size_t i = 0; i < kSums; ++i) {
    sums[i] = 0;
    for (std::size_t k = 0; k < kLanes; ++k) sums[i] += lanes[i][k];
  }
}

void Aligner::evaluate(const CameraRig& rig, const ReferenceLevel& level, const GrayLevel& image,
                       int l, const AlignmentState& state, float cutoff, Sought sought,
                       NormalEquations& normal) {
  const std::size_t groups = level.groups();
  chunks_.resize((groups + kGroupsPerChunk - 1) / kGroupsPerChunk);
  tbb::parallel_for(std::size_t{0}, chunks_.size(), [&](std::size_t i) {
    const std::size_t begin = i * kGroupsPerChunk;
    sumChunk(rig, level, image, l, state, cutoff, sought, begin,
             std::min(begin + kGroupsPerChunk, groups), chunks_[i]);
  });
  std::array<double, kSums> total{};
  for (const Sums& chunk : chunks_) {
    for (std::size_t i = 0; i < kSums; ++i) total[i] += chunk[i];
  }
  std::size_t s = 0;
  for (int i = 0; i < 9; ++i) {
    for (int j = i; j < 9; ++j, ++s) {
      if (j < 8 && sought == Sought::GradientAndH) normal.H(i, j) = normal.H(j, i) = total[s];
      if (j == 8 && i < 8) normal.b[i] = total[s];
    }
  }
  normal.in_view = total[s + 3];
  const double count = std::max(normal.in_view, 1.0);
  normal.energy = total[s] / count;
  normal.squares = total[s + 1] / count;
  normal.inliers = total[s + 2];
}

void Aligner::alignLevel(const CameraRig& rig, const ReferenceLevel& level, const GrayLevel& image,
                         int l, AlignmentState& state, NormalEquations& normal) {
  float cutoff = kCutoff;
  evaluate(rig, level, image, l, state, cutoff, Sought::GradientAndH, normal);
  // The share of 0.4 and the damping (0.01, halved, quadrupled) are those of DSO,
  // the limits chosen, not tuned.
  while (normal.inliers < 0.4 * normal.in_view && cutoff < 6 * kCutoff) {
    cutoff *= 2;
    evaluate(rig, level, image, l, state, cutoff, Sought::GradientAndH, normal);
  }
  double lambda = 0.01;
  NormalEquations next;
  for (int i = 0; i < kIterations[static_cast<std::size_t>(l)]; ++i) {
    Eigen::Matrix<double, 8, 8> damped = normal.H;
    damped.diagonal() *= 1 + lambda;
    damped.diagonal().array() += 1e-6;  // keeps the scaling finite
    const Vector8d scale = damped.diagonal().array().rsqrt();
    const Eigen::Matrix<double, 8, 8> scaled = scale.asDiagonal() * damped * scale.asDiagonal();
    const Vector8d step = -scale.cwiseProduct(scaled.ldlt().solve(scale.cwiseProduct(normal.b)));
    if (!step.allFinite()) return;
    AlignmentState moved = state;
    const Vector6d twist = -step.head<6>();
    moved.T_current_reference = normalised(state.T_current_reference * expSe3(twist));
    moved.brightness.a += step[6];
    moved.brightness.b += step[7];
    evaluate(rig, level, image, l, moved, cutoff, Sought::Gradient, next);
    const bool better = next.energy < normal.energy && next.in_view > 0.5 * normal.in_view;
    if (better) {
      const double gain = 1 - next.energy / normal.energy;
      state = moved;
      next.H = normal.H;
      normal = next;
      lambda = std::max(lambda * 0.5, 1e-5);
      if (gain < 1e-4) return;
    } else {
      lambda *= 4;
    }
    if (step.head<6>().norm() < 1e-4 || lambda > 100) return;
  }
}

AlignmentResult Aligner::align(const CameraRig& rig, const AlignmentReference& reference,
                               const ImagePyramid& image, const AlignmentState& guess, int coarsest,
                               int finest) {
  AlignmentResult result;
  result.state = guess;
  NormalEquations normal;
  for (int l = std::min(coarsest, reference.levels() - 1); l >= finest; --l) {
    alignLevel(rig, reference.level(l), image.level(l), l, result.state, normal);
  }
  const auto all = static_cast<double>(std::max<std::size_t>(reference.level(finest).count, 1));
  result.rms = std::sqrt(normal.squares);
  result.in_view = normal.in_view / all;
  result.inlier_fraction = normal.inliers / std::max(normal.in_view, 1.0);
  result.samples = static_cast<int>(normal.inliers);
  result.information = normal.H;
  return result;
}

void measureFlow(const CameraRig& rig, const AlignmentReference& reference,
                 AlignmentResult& result) {
  const ReferenceLevel& level = reference.level(0);
  const Eigen::Matrix3d R = result.state.T_current_reference.linear();
  const Eigen::Vector3d t = result.state.T_current_reference.translation();
  const double cap = kLargestFlow * (rig.width + rig.height);
  const auto flowOf = [&](const Eigen::Vector3d& moved, const Eigen::Vector3d& ray) {
    const double du = rig.pinhole.fx * (moved.x() / moved.z() - ray.x());
    const double dv = rig.pinhole.fy * (moved.y() / moved.z() - ray.y());
    return std::min(du * du + dv * dv, cap * cap);
  };
  CoverageGrid before(rig);
  CoverageGrid now(rig);
  double flow = 0;
  double translation_flow = 0;
  double count = 0;
  for (std::size_t i = 0; i < level.count; i += 5) {  // bounds the time
    const Eigen::Vector3d ray(level.x[i], level.y[i], 1);
    const double d = level.d[i];
    const Eigen::Vector3d full = R * ray + t * d;
    const Eigen::Vector3d shifted = ray + t * d;
    before.add(ray);
    if (full.z() < 1e-3 || shifted.z() < 1e-3) continue;  // keeps the division finite
    now.add(full / full.z());
    flow += flowOf(full, ray);
    translation_flow += flowOf(shifted, ray);
    ++count;
  }
  result.flow = std::sqrt(flow / std::max(count, 1.0));
  result.translation_flow = std::sqrt(translation_flow / std::max(count, 1.0));
  result.coverage = static_cast<double>(now.taken()) / std::max(1, before.taken());
}

}  // namespace tolman::direct_sparse
