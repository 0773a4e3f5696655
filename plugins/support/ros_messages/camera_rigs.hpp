// SPDX-License-Identifier: BSD-3-Clause
// The cameras of a source whose images are messages, from its parameters or from CameraInfo.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image_conversion.hpp"
#include "message.hpp"
#include "message_cameras.hpp"
#include "tolman/camera.hpp"
#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_messages {

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
