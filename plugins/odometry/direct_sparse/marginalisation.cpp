// SPDX-License-Identifier: BSD-3-Clause
// Schur complements of points and frames onto the prior.
#include "marginalisation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
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

}  // namespace tolman::direct_sparse
