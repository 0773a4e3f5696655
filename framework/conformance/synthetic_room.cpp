// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "conformance/input_sequence.hpp"

namespace tolman::conformance {
namespace {

const Eigen::Vector3d kHalf(6.5, 1.8, 5.5);  // m; half of the sides, all different

/// The first pose is kRadius to the right of the centre.
Eigen::Isometry3d inRoom(const Eigen::Isometry3d& T_world_camera) {
  return Eigen::Translation3d(SyntheticRoom::kRadius, 0, 0) * T_world_camera;
}

double lattice(std::uint64_t key) {
  key = (key ^ (key >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  key = (key ^ (key >> 27U)) * 0x94d049bb133111ebULL;
  return static_cast<double>((key ^ (key >> 31U)) >> 11U) * 0x1.0p-53;
}

}  // namespace

Eigen::Isometry3d SyntheticRoom::poseAt(double angle) {
  return fromPlanar({kRadius * std::sin(angle), kRadius * (1 - std::cos(angle)), angle});
}

SyntheticRoom::Hit SyntheticRoom::castRay(const Eigen::Vector3d& origin,
                                          const Eigen::Vector3d& ray) {
  Hit hit{0, origin, 1e9};
  for (int axis = 0; axis < 3; ++axis) {
    if (ray[axis] == 0) continue;
    const double side = ray[axis] > 0 ? kHalf[axis] : -kHalf[axis];
    const double distance = (side - origin[axis]) / ray[axis];
    if (distance >= hit.distance) continue;
    hit.distance = distance;
    hit.wall = 2 * axis + (ray[axis] > 0 ? 1 : 0);
  }
  hit.point = origin + hit.distance * ray;
  return hit;
}

double SyntheticRoom::noise(std::uint64_t wall, double u, double v) const {
  const double u0 = std::floor(u);
  const double v0 = std::floor(v);
  const double a = u - u0;
  const double b = v - v0;
  const auto corner = [&](double du, double dv) {
    const auto iu = static_cast<std::uint64_t>(static_cast<std::int64_t>(u0 + du) + 4096);
    const auto iv = static_cast<std::uint64_t>(static_cast<std::int64_t>(v0 + dv) + 4096);
    return lattice(seed_ * 0x9e3779b97f4a7c15ULL + (wall << 32U) + (iu << 16U) + iv);
  };
  const double top = corner(0, 0) * (1 - a) + corner(1, 0) * a;
  const double bottom = corner(0, 1) * (1 - a) + corner(1, 1) * a;
  return top * (1 - b) + bottom * b;
}

double SyntheticRoom::greyLevel(const Hit& hit) const {
  const int axis = hit.wall / 2;
  const double u = hit.point[(axis + 1) % 3];
  const double v = hit.point[(axis + 2) % 3];
  const auto wall = static_cast<std::uint64_t>(hit.wall);
  const double coarse = noise(wall, 1.5 * u, 1.5 * v);
  const double fine = noise(wall + 8, 7 * u, 7 * v);
  return 20 + 130 * coarse + 90 * fine;
}

Image SyntheticRoom::view(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig,
                          double offset, PixelFormat format) const {
  const Eigen::Isometry3d T = inRoom(T_world_camera);
  const Eigen::Vector3d origin = T * Eigen::Vector3d(offset, 0, 0);
  const int channels = bytesPerPixel(format);
  return Image::create(rig.width, rig.height, format, [&](std::uint8_t* pixel) {
    for (int y = 0; y < rig.height; ++y) {
      for (int x = 0; x < rig.width; ++x) {
        const auto grey = static_cast<std::uint8_t>(
            greyLevel(castRay(origin, T.linear() * rig.pinhole.ray(Eigen::Vector2d(x, y)))));
        pixel = std::fill_n(pixel, channels, grey);
      }
    }
  });
}

double SyntheticRoom::depth(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig,
                            const Eigen::Vector2d& pixel) {
  const Eigen::Isometry3d T = inRoom(T_world_camera);
  return castRay(T.translation(), T.linear() * rig.pinhole.ray(pixel)).distance;
}

}  // namespace tolman::conformance
