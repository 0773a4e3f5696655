// SPDX-License-Identifier: BSD-3-Clause
// Names of the topics of a camera or a stereo pair.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

}  // namespace tolman::ros_messages
