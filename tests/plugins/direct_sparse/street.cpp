// SPDX-License-Identifier: BSD-3-Clause
// Depth by intersection with the four planes of the rendered street.
#include "street.hpp"

#include <limits>

#include "point_selection.hpp"

namespace tolman::test {

using namespace direct_sparse;

Eigen::Isometry3d streetPose(double z, double yaw) {
  return Eigen::Isometry3d(Eigen::Translation3d(0, 0, z)) *
         Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY());
}

double streetInverseDepth(const Eigen::Isometry3d& T_world_camera, double u, double v) {
  constexpr double kPlanes[4][2] = {{1, 1.5}, {0, -5}, {0, 6}, {2, 60}};  // axis, position
  const Eigen::Vector3d ray = T_world_camera.linear() * streetRig().pinhole.ray({u, v});
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& plane : kPlanes) {
    const auto axis = static_cast<Eigen::Index>(plane[0]);
    const double s = (plane[1] - T_world_camera.translation()[axis]) / ray[axis];
    if (s > 0.1 && s < nearest) nearest = s;
  }
  return 1 / nearest;
}

std::unique_ptr<Window> streetWindow(const std::vector<Eigen::Isometry3d>& poses) {
  auto window = std::make_unique<Window>();
  const CameraRig rig = streetRig();
  window->field.configure(rig.width, rig.height, rig.pinhole.fx, rig.pinhole.fx * rig.baseline, 0);
  std::int64_t index = 0;
  for (const Eigen::Isometry3d& pose : poses) {
    const Frame frame = streetFrame(index, pose);
    Keyframe& keyframe = window->add();
    keyframe.frame = index++;
    keyframe.T0_camera_world = pose.inverse();
    keyframe.left.build(frame.left);
    keyframe.right.build(frame.right, 1);
    keyframe.has_right = true;
    keyframe.right_gain = 1;
    keyframe.right_offset = 0;
  }
  return window;
}

/// The sums of a point in a target; false where it is not seen.
bool sumsIn(const PairGeometry& pair, const GrayLevel& target, const Point& point,
            PixelSums& sums) {
  PatternPlaces places;
  placePattern(pair, target, point, places);
  if (places.inside) sums = temporalSums(pair, target, point.pattern, places);
  return places.inside;
}

void addTruePoints(Window& window, int wanted) {
  PointSelector selector;
  for (const int slot : window.order()) {
    Keyframe& keyframe = window.keyframe(slot);
    for (const Pixel& pixel : selector.select(keyframe.left.level(0), wanted, 6)) {
      Point point;
      point.u = static_cast<float>(pixel.u);
      point.v = static_cast<float>(pixel.v);
      point.inverse_depth =
          static_cast<float>(streetInverseDepth(keyframe.T_world_camera(), pixel.u, pixel.v));
      point.pattern = patternAt(keyframe.left.level(0), pixel.u, pixel.v);
      for (const int target : window.order()) {
        if (target == slot) continue;
        point.temporal[static_cast<std::size_t>(target)] = ResidualState::Good;
      }
      point.stereo = ResidualState::Good;
      keyframe.points.push_back(point);
    }
  }
}

ImagePyramid streetPyramid(const Eigen::Isometry3d& T_world_camera) {
  ImagePyramid pyramid;
  pyramid.build(streetFrame(0, T_world_camera).left);
  return pyramid;
}

}  // namespace tolman::test
