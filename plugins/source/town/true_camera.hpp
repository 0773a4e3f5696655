// SPDX-License-Identifier: BSD-3-Clause
// The true cameras, which differ from the rig of the calibration.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "pixel_warp.hpp"
#include "tolman/camera.hpp"
#include "tolman/status.hpp"
#include "town_parameters.hpp"

namespace tolman::town {

struct TrueCamera {
  Pinhole pinhole;
  Eigen::Isometry3d T_left_camera = Eigen::Isometry3d::Identity();
  PixelWarp warp;
};

/// Left and right camera; refuses lists of a wrong length.
Result<std::array<TrueCamera, 2>> trueCameras(const TownParameters& parameters,
                                              const CameraRig& calibrated);

}  // namespace tolman::town
