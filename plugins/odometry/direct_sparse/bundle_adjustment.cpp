// SPDX-License-Identifier: BSD-3-Clause
// Gauss-Newton steps of the window.
#include "bundle_adjustment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tolman::direct_sparse {
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
