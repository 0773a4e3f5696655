// SPDX-License-Identifier: BSD-3-Clause
// Cameras and pairs of them among the topics: names, and rigs of their CameraInfo.
//
// Names of the topics of a camera or a stereo pair.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image_conversion.hpp"
#include "message_cameras.hpp"
#include "messages.hpp"
#include "tolman/camera.hpp"
#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_messages {

/// Whether the names are those of a left and a right camera: they differ in "left" and "right", or
/// in one digit by one.
bool isPair(const std::string& left, const std::string& right);

struct CameraNames {
  std::string left;
  std::string right;  ///< empty with one camera
};

/// Completes `named`, which comes from the parameters, from `cameras`. Empty if there is more than
/// one possibility; chooseBy() then names the parameter to set.
std::optional<CameraNames> chooseCameraNames(const std::vector<std::string>& cameras,
                                             const CameraNames& named, bool mono);
/// The parameter that the user must set to choose.
inline const char* chooseBy(const CameraNames& named) {
  return named.left.empty() ? "left" : "right";
}

/// The topic of CameraInfo for images: /left/camera_info for /left/image_raw and
/// /left/image_raw/compressed.
std::string infoBeside(const std::string& images);

// The cameras of a source whose images are messages, from its parameters or from CameraInfo.

using source_parameters::CameraParameters;

/// One camera: its topics, and a CameraInfo where there is one.
struct CameraTopic {
  std::string images;
  std::string info_name;
  std::optional<Message> info;
};

/// At most one of the two is set; with neither, images are uncalibrated, of the size in
/// `rectified`.
struct CameraRigs {
  CameraRig rectified;
  RawRig raw;
  std::vector<Finding> findings;  ///< what was decided, and what is odd

  /// Suffix of the text that describes a source.
  std::string suffix() const {
    if (rectified.calibrated) return "";
    return raw.cameras.empty() ? ", uncalibrated" : ", raw";
  }
};

/// InvalidParameter for parameters that contradict each other.
Status checkCombination(const CameraParameters& parameters);

/// `right`: null with one camera. InvalidInput or InvalidParameter without a complete calibration.
Result<CameraRigs> makeRigs(const CameraParameters& parameters, ImageSize size,
                            const CameraTopic& left, const CameraTopic* right);

}  // namespace tolman::ros_messages
