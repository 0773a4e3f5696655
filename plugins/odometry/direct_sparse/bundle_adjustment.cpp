// SPDX-License-Identifier: BSD-3-Clause
// Schur complements of points and frames onto the prior.
#include "bundle_adjustment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace tolman::direct_sparse {

namespace {

bool contains(const std::vector<int>& slots, int slot) {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

double distance(const Keyframe& a, const Keyframe& b) {
  return (a.T_world_camera().translation() - b.T_world_camera().translation()).norm();
}

/// Index in order() of the first of the two newest keyframes.
std::size_t protectedFrom(const Window& window) { return window.order().size() - 2; }

/// Distance score of Engel et al.: high for a keyframe close to others and far from the newest.
double crowding(const Window& window, int slot) {
  const Keyframe& keyframe = window.keyframe(slot);
  double sum = 0;
  for (const int other : window.order()) {
    if (other == slot || other == window.newestSlot()) continue;
    sum += 1 / (1e-5 + distance(keyframe, window.keyframe(other)));
  }
  return sum * std::sqrt(distance(keyframe, window.newest()));
}

bool exhausted(const Window& window, int slot) {
  constexpr double kMin = 0.05;
  constexpr double kBrightnessChange = 0.7;  // of the logarithm; both as in DSO
  const Keyframe& keyframe = window.keyframe(slot);
  const double kept = static_cast<double>(keyframe.points.size() + keyframe.immature.size());
  const double made = static_cast<double>(keyframe.points_made) + kept;
  return kept < kMin * made ||
         std::fabs(keyframe.affine().a - window.newest().affine().a) > kBrightnessChange;
}

/// Whether the point is neither seen nor hosted by the two newest keyframes.
bool outOfSight(const Window& window, int host, const Point& point) {
  const std::vector<int>& order = window.order();
  for (std::size_t i = protectedFrom(window); i < order.size(); ++i) {
    if (order[i] == host) return false;
    if (point.temporal[static_cast<std::size_t>(order[i])] == ResidualState::Good) return false;
  }
  return true;
}

using FrameBlock = Eigen::Matrix<double, kFrameVariables, kFrameVariables>;

/// Derivatives of the variables of `keyframe` by those of `anchor`, at the first estimates, when
/// the pose or brightness of the whole window changes.
FrameBlock byGauge(const Keyframe& keyframe, const Keyframe& anchor) {
  const Eigen::Isometry3d T = keyframe.T0_camera_world * anchor.T0_camera_world.inverse();
  FrameBlock moved = FrameBlock::Zero();
  moved.block<3, 3>(0, 0) = T.linear();
  moved.block<3, 3>(3, 3) = T.linear();
  moved.block<3, 3>(0, 3) = skew(T.translation()) * T.linear();
  moved(6, 6) = 1;
  moved(7, 7) = std::exp(keyframe.affine0.a - anchor.affine0.a);
  return moved;
}

bool worthKeeping(const Point& point) {
  constexpr float kMinInformation = 50;  // m^2; as in DSO (Engel et al.)
  return point.information > kMinInformation && point.seen_good >= 3;
}

}  // namespace

std::vector<int> chooseLeaving(const Window& window, int most) {
  std::vector<int> leaving;
  if (window.size() <= 2) return leaving;
  const std::vector<int>& order = window.order();
  const int fewest = std::max(2, most - 2);  // 5 of 7 as in DSO
  for (std::size_t i = 0; i < protectedFrom(window); ++i) {
    const int left = window.size() - static_cast<int>(leaving.size());
    if (left > fewest && exhausted(window, order[i])) leaving.push_back(order[i]);
  }
  while (window.size() - static_cast<int>(leaving.size()) > most) {
    int worst = -1;
    double worst_score = -1;
    for (std::size_t i = 0; i < protectedFrom(window); ++i) {
      const double score = crowding(window, order[i]);
      if (contains(leaving, order[i]) || score <= worst_score) continue;
      worst = order[i];
      worst_score = score;
    }
    leaving.push_back(worst);
  }
  return leaving;
}

void marginalisePoints(const CameraRig& rig, const SystemSettings& settings,
                       const std::vector<int>& leaving, double weight, Window& window,
                       LinearSystem& system) {
  if (window.size() < 2) return;
  std::vector<PointRange> ranges;
  for (const int slot : window.order()) {
    std::vector<Point>& points = window.keyframe(slot).points;
    const bool host_leaves = contains(leaving, slot);
    const auto goes = [&](const Point& p) { return host_leaves || outOfSight(window, slot, p); };
    std::erase_if(points, [&](const Point& p) { return goes(p) && !worthKeeping(p); });
    const auto first = std::stable_partition(points.begin(), points.end(),
                                             [&](const Point& p) { return !goes(p); });
    ranges.push_back(
        {slot, static_cast<int>(first - points.begin()), static_cast<int>(points.size())});
  }
  system.build(rig, settings, window, ranges);
  // The system's gradient is at the present state, that of the prior is at the first estimates.
  window.prior.H += weight * system.H();
  window.prior.b += weight * (system.b() - system.H() * changes(window));
  for (const PointRange& range : ranges) {
    std::vector<Point>& points = window.keyframe(range.host).points;
    points.erase(points.begin() + range.begin, points.end());
  }
  for (const int slot : window.order()) {
    const int i = kFrameVariables * slot;
    Keyframe& keyframe = window.keyframe(slot);
    keyframe.has_prior = keyframe.has_prior || window.prior.H(i, i) > 0;
  }
}

void marginaliseKeyframe(int slot, Window& window) {
  constexpr int n = kFrameVariables;
  const int i = n * slot;
  SystemMatrix& H = window.prior.H;
  SystemVector& b = window.prior.b;
  using Block = FrameBlock;
  const Block own = 0.5 * (H.block<n, n>(i, i) + H.block<n, n>(i, i).transpose());
  const Eigen::Matrix<double, n, 1> scale = (own.diagonal().array() + 1e-3).rsqrt();
  Block scaled = scale.asDiagonal() * own * scale.asDiagonal();
  scaled.diagonal().array() += 1e-9;  // keeps the inverse finite
  const Block inverse =
      scale.asDiagonal() * Eigen::LDLT<Block>(scaled).solve(Block::Identity()) * scale.asDiagonal();
  const Eigen::Matrix<double, kVariables, n> across = H.middleCols<n>(i);
  const Eigen::Matrix<double, kVariables, n> gain = across * inverse;
  b -= gain * b.segment<n>(i);
  H -= gain * across.transpose();
  H.middleRows<n>(i).setZero();
  H.middleCols<n>(i).setZero();
  b.segment<n>(i).setZero();
  H = (0.5 * (H + H.transpose())).eval();
  window.remove(slot);
}

void projectOutGauge(Window& window) {
  constexpr int n = kFrameVariables;
  const auto with_prior = [&](int slot) { return window.keyframe(slot).has_prior; };
  const auto first = std::find_if(window.order().begin(), window.order().end(), with_prior);
  if (first == window.order().end()) return;
  SystemMatrix& H = window.prior.H;
  SystemVector& b = window.prior.b;
  const int anchor = n * *first;
  // The blocks of the other keyframes do not change. Those of the anchor follow from H N = 0 and
  // N' b = 0, N being the null space.
  Eigen::Matrix<double, kVariables, n> column = Eigen::Matrix<double, kVariables, n>::Zero();
  Eigen::Matrix<double, n, 1> gradient = Eigen::Matrix<double, n, 1>::Zero();
  for (const int slot : window.order()) {
    if (slot == *first || !with_prior(slot)) continue;
    const FrameBlock N = byGauge(window.keyframe(slot), window.keyframe(*first));
    column -= H.middleCols<n>(n * slot) * N;
    gradient -= N.transpose() * b.segment<n>(n * slot);
  }
  column.middleRows<n>(anchor).setZero();
  H.middleCols<n>(anchor) = column;
  H.middleRows<n>(anchor) = column.transpose();
  FrameBlock own = FrameBlock::Zero();
  for (const int slot : window.order()) {
    if (slot == *first || !with_prior(slot)) continue;
    const FrameBlock N = byGauge(window.keyframe(slot), window.keyframe(*first));
    own -= N.transpose() * column.middleRows<n>(n * slot);
  }
  H.block<n, n>(anchor, anchor) = 0.5 * (own + own.transpose());
  b.segment<n>(anchor) = gradient;
}

// Gauss-Newton steps of the window.

namespace {

/// Root mean squares of the parts of a step over the keyframes.
struct StepSize {
  double metres = 0;
  double radians = 0;
  double a = 0;
  double b = 0;
};

StepSize apply(Window& window, const SystemVector& step) {
  StepSize size;
  for (const int slot : window.order()) {
    Keyframe& keyframe = window.keyframe(slot);
    const Vector8d part = step.segment<kFrameVariables>(kFrameVariables * slot);
    keyframe.change += part;
    // No prior is linearised at the first estimate of this keyframe yet, so it may change.
    if (!keyframe.has_prior) keyframe.relinearise();
    size.metres += part.head<3>().squaredNorm();
    size.radians += part.segment<3>(3).squaredNorm();
    size.a += part[6] * part[6];
    size.b += part[7] * part[7];
  }
  window.field.move(step.tail<kFieldVariables>());
  const double frames = window.size();
  return {std::sqrt(size.metres / frames), std::sqrt(size.radians / frames),
          std::sqrt(size.a / frames), std::sqrt(size.b / frames)};
}

using Poses = std::array<Eigen::Isometry3d, kSlots>;

/// Poses of the keyframes in the camera frame of the oldest one, by slot.
Poses posesInOldest(const Window& window) {
  Poses poses;
  const Eigen::Isometry3d T_oldest_world = window.keyframe(window.order().front()).T_camera_world();
  for (const int slot : window.order()) {
    poses.at(static_cast<std::size_t>(slot)) =
        T_oldest_world * window.keyframe(slot).T_world_camera();
  }
  return poses;
}

void measureMoves(const Window& window, const Poses& before, AdjustmentResult& result) {
  const Poses after = posesInOldest(window);
  for (const int slot : window.order()) {
    const auto i = static_cast<std::size_t>(slot);
    const Eigen::Isometry3d move = before.at(i).inverse() * after.at(i);
    result.metres = std::max(result.metres, move.translation().norm());
    result.radians = std::max(result.radians, logSo3(move.linear()).norm());
  }
}

}  // namespace

AdjustmentResult adjustWindow(const CameraRig& rig, const AdjustmentSettings& settings,
                              Window& window, LinearSystem& system) {
  AdjustmentResult result;
  const Poses before = posesInOldest(window);
  const std::vector<PointRange> points = allPoints(window);
  SystemVector step = SystemVector::Zero();
  for (int i = 0; i < settings.iterations; ++i) {
    system.build(rig, settings.system, window, points);
    result.iterations = i + 1;
    result.energy = system.energy();
    result.residuals = system.residuals();
    if (i == 0) window.moments.add(system.moments());
    step = solve(window, system.H(), system.b(), settings.scale);
    const double depth_change = system.applyToDepths(window, step);
    const StepSize size = apply(window, step);
    // Root mean squares of a step, m, rad and grey levels. The one of a is that of DSO,
    // the others are chosen, not tuned.
    const bool small = size.metres < 2e-4 && size.radians < 1e-5 && size.a < 6e-4 &&
                       size.b < 0.06 && depth_change < 1e-3;
    if (small) break;
  }
  if (settings.iterations > 0) {
    system.storeInformation(window);
    window.energy_threshold = system.outlierThreshold();
  }
  SmoothField field{window.field.changes()};
  if (settings.watch_field && !window.field.isOn()) {
    // By the last linearisation, whose gradient has changed by the step.
    field = fieldIfOn(window, system.H(), system.b() + system.H() * step, settings.scale);
  }
  result.field_rms = field.rmsWithoutOffset();
  measureMoves(window, before, result);
  return result;
}

void dropOutliers(Window& window) {
  for (const int slot : window.order()) {
    Keyframe& keyframe = window.keyframe(slot);
    std::erase_if(keyframe.points, [](Point& point) {
      int had = point.stereo != ResidualState::Absent ? 1 : 0;
      int left = 0;
      for (ResidualState& state : point.temporal) {
        had += state != ResidualState::Absent ? 1 : 0;
        if (state != ResidualState::Good) state = ResidualState::Absent;
        left += state == ResidualState::Good ? 1 : 0;
      }
      if (point.stereo != ResidualState::Good) point.stereo = ResidualState::Absent;
      left += point.stereo == ResidualState::Good ? 1 : 0;
      return had > 0 && left == 0;  // a new point may have no residual yet
    });
  }
}

}  // namespace tolman::direct_sparse
