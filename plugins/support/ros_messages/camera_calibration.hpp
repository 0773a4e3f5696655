// SPDX-License-Identifier: BSD-3-Clause
// The calibration in CameraInfo: of rectified images, or of raw ones, which the host rectifies.
#pragma once

#include <optional>
#include <string>

#include "messages.hpp"
#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_messages {

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
