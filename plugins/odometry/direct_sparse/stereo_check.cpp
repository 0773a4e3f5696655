// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "static_stereo.hpp"

namespace tolman::direct_sparse {
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
