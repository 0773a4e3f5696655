// SPDX-License-Identifier: BSD-3-Clause
// Effects of rain and snow on surfaces.
#pragma once

#include "light.hpp"
#include "material.hpp"

namespace tolman::town {

/// Albedo of a surface whose dry albedo is `dry`. `normal` and `point` in town axes.
float weatheredAlbedo(float dry, const Surface& surface, const Vec3& point, const Vec3& normal,
                      float footprint, const Light& light, const StreetPlan& plan);

/// Share of light that wet ground reflects to a camera that looks along `way` (unit); 0 for
/// surfaces that are not ground.
float mirroredShare(const Surface& surface, const Vec3& point, const Vec3& normal, const Vec3& way,
                    const Light& light);

/// The same for a pane that covers the share `glass` of the pixel.
float mirroredByGlass(float glass, const Vec3& normal, const Vec3& way);

}  // namespace tolman::town
