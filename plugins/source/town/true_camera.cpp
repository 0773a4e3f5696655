// SPDX-License-Identifier: BSD-3-Clause
#include "true_camera.hpp"

#include <numbers>
#include <string>

#include "noise.hpp"
#include "tolman/geometry.hpp"

namespace tolman::town {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Status expectCount(std::string_view name, const std::vector<double>& list, std::size_t wanted,
                   std::string_view items) {
  if (list.size() == wanted) return Status::ok();
  return Status::invalidParameter(std::string(name) + " has " + std::to_string(list.size()) +
                                  " values; give " + std::to_string(wanted) + ": [" +
                                  std::string(items) + "]");
}

Status checkLists(const TownParameters& p) {
  for (const Status& status :
       {expectCount("focal_length_error", p.focal_length_error, 2, "left, right"),
        expectCount("principal_point_error_px", p.principal_point_error_px, 4,
                    "left x, left y, right x, right y"),
        expectCount("right_rotation_error_deg", p.right_rotation_error_deg, 3, "yaw, pitch, roll"),
        expectCount("gain", p.gain, 2, "left, right"),
        expectCount("gamma", p.gamma, 2, "left, right"),
        expectCount("vignetting_error", p.vignetting_error, 2, "left, right")}) {
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

Eigen::Isometry3d rightCamera(const TownParameters& p, double baseline) {
  Eigen::Isometry3d T_left_right = Eigen::Isometry3d::Identity();
  T_left_right.linear() = expSo3(Eigen::Vector3d::Constant(p.rotation_error * kDegree));
  const std::vector<double>& turn = p.right_rotation_error_deg;
  const Eigen::Vector3d axes(turn[1], turn[0], turn[2]);  // X is right, Y down, Z forward
  if (!axes.isZero(0)) T_left_right.linear() *= expSo3(axes * kDegree);
  T_left_right.translation().x() = baseline * (1 + p.baseline_error);
  return T_left_right;
}

}  // namespace

Result<std::array<TrueCamera, 2>> trueCameras(const TownParameters& p,
                                              const CameraRig& calibrated) {
  if (const Status status = checkLists(p); !status.isOk()) return status;
  std::array<TrueCamera, 2> cameras;
  for (std::size_t i = 0; i < 2; ++i) {
    TrueCamera& camera = cameras[i];
    camera.pinhole = calibrated.pinhole;
    camera.pinhole.fx *= 1 + p.focal_length_error[i];
    camera.pinhole.fy *= 1 + p.focal_length_error[i];
    camera.pinhole.cx += p.scale * p.principal_point_error_px[2 * i];
    camera.pinhole.cy += p.scale * p.principal_point_error_px[2 * i + 1];
    camera.warp = makeWarp(
        calibrated.width, calibrated.height, p.scale * p.warp_rms_px,
        hash(static_cast<std::uint32_t>(p.camera_seed), static_cast<std::uint32_t>(i), 501));
  }
  cameras[1].T_left_camera = rightCamera(p, calibrated.baseline);
  return cameras;
}

}  // namespace tolman::town
