// SPDX-License-Identifier: BSD-3-Clause
// Projects points through the lens of a raw camera.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "tolman/camera.hpp"

namespace tolman::engine {

class Lens {
 public:
  explicit Lens(const RawCamera& camera);

  /// The pixel of a point of the camera frame at any distance; it may be outside of the image. None
  /// behind the camera, and beyond the angle from which the polynomial of the distortion decreases:
  /// there it would map rays that the image does not show.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point) const;
  /// The same as project(), but none outside of the image.
  std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& point) const;
  /// Pixels per unit of x/z at the centre of the image.
  double focal() const;
  /// Whether the camera is a pinhole without distortion.
  bool isPinhole() const;

 private:
  double distorted(double radius) const;
  Eigen::Vector2d distorted(const Eigen::Vector2d& p) const;

  RawCamera camera_;
  double limit_ = 0;  ///< radius, or angle for Equidistant, up to which the distortion grows
};

}  // namespace tolman::engine
