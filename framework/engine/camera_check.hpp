// SPDX-License-Identifier: BSD-3-Clause
// Whether a calibration can be that of these images: one of images in another size gives depths and
// paths that are wrong by a factor, and contradicts nothing else.
#pragma once

#include <string>
#include <vector>

#include "tolman/camera.hpp"

namespace tolman::imaging {

/// What to look at where the principal point is not near the middle of the images, or where the
/// focal length gives a view that rectified images hardly have; none for other cameras, and for
/// those without calibration.
std::vector<std::string> cameraDoubts(const CameraRig& rig);

/// The same of raw cameras, with "left" and "right", and where the two focal lengths of one do not
/// fit each other; wider views are usual there.
std::vector<std::string> cameraDoubts(const RawRig& rig);

}  // namespace tolman::imaging
