// SPDX-License-Identifier: BSD-3-Clause
#include "engine/lens.hpp"

#include <cmath>

namespace tolman::engine {
namespace {

// Limits of the distortion model: 84 degrees for a pinhole, the whole sphere for a fisheye.
constexpr double kMaxRadius = 10;
constexpr double kMaxAngle = 3.14159265358979;
constexpr double kLensStep = 1e-3;

}  // namespace

Lens::Lens(const RawCamera& camera) : camera_(camera) {
  const double most = camera.model == LensModel::Equidistant ? kMaxAngle : kMaxRadius;
  for (double before = 0; limit_ < most; limit_ += kLensStep) {
    const double here = distorted(limit_ + kLensStep);
    if (!(here > before)) break;  // also for NaN
    before = here;
  }
}

bool Lens::isPinhole() const {
  const bool straight = camera_.distortion.isZero(0) && camera_.xi == 0;
  return camera_.model == LensModel::Pinhole ||
         (straight && camera_.model != LensModel::Equidistant);
}

double Lens::focal() const {
  const double f = 0.5 * (camera_.pinhole.fx + camera_.pinhole.fy);
  return camera_.model == LensModel::Omnidirectional ? f / (1 + camera_.xi) : f;
}

/// Radial distortion of a radius, or of an angle for Equidistant.
double Lens::distorted(double radius) const {
  const auto& k = camera_.distortion;
  const double s = radius * radius;
  switch (camera_.model) {
    case LensModel::Pinhole:
      return radius;
    case LensModel::Equidistant:
      return radius * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
    case LensModel::RadialTangential:
    case LensModel::Omnidirectional:
      break;
  }
  return radius * (1 + s * (k[0] + s * (k[1] + s * k[4]))) /
         (1 + s * (k[5] + s * (k[6] + s * k[7])));
}

/// Radial and tangential distortion (Brown 1966, in the form of OpenCV).
Eigen::Vector2d Lens::distorted(const Eigen::Vector2d& p) const {
  const double p1 = camera_.distortion[2];
  const double p2 = camera_.distortion[3];
  const double radius = p.norm();
  const double ratio = radius > 0 ? distorted(radius) / radius : 1;
  const double s = radius * radius;
  const double xy = 2 * p.x() * p.y();
  return {p.x() * ratio + p1 * xy + p2 * (s + 2 * p.x() * p.x()),
          p.y() * ratio + p1 * (s + 2 * p.y() * p.y()) + p2 * xy};
}

std::optional<Eigen::Vector2d> Lens::project(const Eigen::Vector3d& point) const {
  const Pinhole& K = camera_.pinhole;
  Eigen::Vector2d p;
  if (camera_.model == LensModel::Equidistant) {
    const double across = point.head<2>().norm();
    const double angle = std::atan2(across, point.z());
    if (angle > limit_) return std::nullopt;
    p = across > 0 ? Eigen::Vector2d(point.head<2>() * (distorted(angle) / across))
                   : Eigen::Vector2d(0, 0);
  } else {
    const bool is_mirror = camera_.model == LensModel::Omnidirectional;
    const double depth = point.z() + (is_mirror ? camera_.xi * point.norm() : 0);
    if (depth <= 0) return std::nullopt;
    p = point.head<2>() / depth;
    if (p.norm() > limit_) return std::nullopt;
    if (camera_.model != LensModel::Pinhole) p = distorted(p);
  }
  return Eigen::Vector2d(K.fx * p.x() + K.cx, K.fy * p.y() + K.cy);
}

std::optional<Eigen::Vector2d> Lens::pixelOf(const Eigen::Vector3d& point) const {
  const auto pixel = project(point);
  const bool inside = pixel && pixel->x() >= 0 && pixel->x() <= camera_.width - 1 &&
                      pixel->y() >= 0 && pixel->y() <= camera_.height - 1;
  return inside ? pixel : std::nullopt;
}

}  // namespace tolman::engine
