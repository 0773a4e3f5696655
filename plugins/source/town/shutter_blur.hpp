// SPDX-License-Identifier: BSD-3-Clause
// Motion blur of an image from the depth and the motion of the camera and of objects, without
// tracing more rays. It is right for surfaces whose neighbourhood moves alike, and approximate at
// silhouettes, where an image does not tell what is behind.
#pragma once

#include <vector>

#include "pixel_paths.hpp"
#include "renderer.hpp"

namespace tolman::town {

/// Mean radiance while the shutter is open; `sharp` is the picture of `view`, in the middle of this
/// time.
std::vector<float> shutterBlur(const RenderCamera& view, const RenderedImage& sharp,
                               const OpenShutter& shutter);

}  // namespace tolman::town
