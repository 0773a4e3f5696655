// SPDX-License-Identifier: BSD-3-Clause
// What a CameraInfo says, and where it contradicts itself, the images, or what is read of it.
// Failures do not name the topic; the caller adds it.
#pragma once

#include <Eigen/Core>

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

}  // namespace tolman::ros_messages
