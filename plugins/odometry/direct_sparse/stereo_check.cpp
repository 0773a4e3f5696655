// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "static_stereo.hpp"

namespace tolman::direct_sparse {
namespace {

constexpr std::size_t kMostCompared = 300;

/// A point of the window in the new frame: pixel and disparity, px.
struct Expected {
  int u = 0;
  int v = 0;
  double disparity = 0;
};

std::optional<Expected> expected(const CameraRig& rig, const Eigen::Isometry3d& T_camera_host,
                                 const Point& point) {
  const Pinhole& camera = rig.pinhole;
  const Eigen::Vector3d ray((point.u - camera.cx) / camera.fx, (point.v - camera.cy) / camera.fy,
                            1);
  const Eigen::Vector3d p = T_camera_host.linear() * ray +
                            T_camera_host.translation() * static_cast<double>(point.inverse_depth);
  if (!(p.z() > 1e-3)) return std::nullopt;
  const double u = camera.fx * p.x() / p.z() + camera.cx;
  const double v = camera.fy * p.y() / p.z() + camera.cy;
  const auto inside = [](double x, int size) {
    return x >= kStereoBorder && x < size - kStereoBorder - 1;
  };
  if (!inside(u, rig.width) || !inside(v, rig.height)) return std::nullopt;
  return Expected{static_cast<int>(std::lround(u)), static_cast<int>(std::lround(v)),
                  camera.fx * rig.baseline * static_cast<double>(point.inverse_depth) / p.z()};
}

}  // namespace

StereoAgreement compareWithStereo(const CameraRig& rig, const Window& window,
                                  const Eigen::Isometry3d& T_world_camera, const GrayLevel& left,
                                  const GrayLevel& right, int max_disparity) {
  // A wrong place is off by metres; moving objects and edges of depth disagree anywhere.
  constexpr double kSlack = 1;     // px
  constexpr double kShare = 0.15;  // of the disparity
  StereoSearch search;
  search.max_disparity = max_disparity;
  balanceBrightness(left, right, search);
  const std::size_t step = 1 + window.pointCount() / kMostCompared;
  std::size_t number = 0;
  StereoAgreement agreement;
  for (const int slot : window.order()) {
    const Keyframe& host = window.keyframe(slot);
    const Eigen::Isometry3d T_camera_host = T_world_camera.inverse() * host.T_world_camera();
    for (const Point& point : host.points) {
      if (number++ % step != 0) continue;
      const auto there = expected(rig, T_camera_host, point);
      if (!there) continue;
      const auto match = matchStereo(left, right, there->u, there->v, search);
      if (!match) continue;
      const double measured = static_cast<double>(match->disparity) + window.offset.value();
      ++agreement.compared;
      const double error = std::fabs(measured - there->disparity);
      agreement.agreeing += error < kSlack + kShare * measured ? 1 : 0;
    }
  }
  return agreement;
}

}  // namespace tolman::direct_sparse
