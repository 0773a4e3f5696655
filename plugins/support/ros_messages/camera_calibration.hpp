// SPDX-License-Identifier: BSD-3-Clause
// Calibrations from CameraInfo.
//
// What a CameraInfo says, and where it contradicts itself, the images, or what is read of it.
// Failures do not name the topic; the caller adds it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "messages.hpp"
#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_messages {

Eigen::Matrix3d rotationOf(const CameraInfoMessage& info);
/// Whether R is neither the identity nor zeros, which ROS leaves where there is no calibration.
bool isTurned(const CameraInfoMessage& info);
bool hasP(const CameraInfoMessage& info);
Pinhole pinholeOfP(const CameraInfoMessage& info);
/// Position of camera 0 in the frame of this rectified one, m: P is K (I, t). Zero without P.
Eigen::Vector3d offsetOf(const CameraInfoMessage& info);

/// Whether R is a rotation, or zeros.
Status checkRotation(const CameraInfoMessage& info);
/// Whether K and P are matrices without skew, as far as they are there.
Status checkForms(const CameraInfoMessage& info);
/// Whether the images are whole, and of the size of the calibration.
Status checkSize(const CameraInfoMessage& info, int width, int height);
Status checkPinhole(const Pinhole& K, int width, int height);

// The calibration in CameraInfo: of rectified images, or of raw ones, which the host rectifies.

/// The messages of one camera or a pair.
struct CameraInfos {
  CameraInfoMessage left;
  std::optional<CameraInfoMessage> right;
  std::string left_name{};  ///< of the topic, for messages
  std::string right_name{};
};

/// Whether the images are rectified: the last part of the topic is `image_rect...`, as image_proc
/// names its results, or there is no distortion, no rotation, and one camera matrix for raw and
/// rectified images.
bool isRectified(const std::string& topic, const CameraInfos& infos);

/// Whether P[3] of the right camera is that of a left one. The baseline is its size all the same.
bool hasWrongSign(const CameraInfos& infos);

/// The rig of rectified images of this size, from P. InvalidInput for an invalid calibration.
Result<CameraRig> rectifiedRig(const CameraInfos& infos, int width, int height);

/// The cameras of raw images of this size, from K, D, R and P.
Result<RawRig> rawRig(const CameraInfos& infos, int width, int height);

}  // namespace tolman::ros_messages
