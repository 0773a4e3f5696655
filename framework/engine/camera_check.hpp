// SPDX-License-Identifier: BSD-3-Clause
// Whether a calibration can be that of these images. One of images in another size, a baseline in
// millimetres or a wrong focal length gives depths and paths that are wrong by a factor, and
// contradicts nothing else.
#pragma once

#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/image.hpp"

namespace tolman::engine {

/// What to look at in the cameras of a source: a baseline below 1 cm or above 10 m, a principal
/// point far from the middle of the image, focal lengths that differ between the two directions by
/// more than 5 %, or that give a view which such cameras do not have. `raw` is empty where the
/// source gives rectified images; `rectified` is the rig that the stages get.
std::vector<std::string> cameraDoubts(const RawRig& raw, const CameraRig& rectified);

/// Whether the image is nearly black, as images of 14 bits or fewer that are taken for 16 bits: not
/// one in ten thousand values (a hot pixel) reaches a quarter of the grey levels. False for an
/// empty image.
bool isNearlyBlack(const Image& image);

}  // namespace tolman::engine
