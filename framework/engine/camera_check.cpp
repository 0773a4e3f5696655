// SPDX-License-Identifier: BSD-3-Clause
#include "engine/camera_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/pixel_check.hpp"

namespace tolman::imaging {
namespace {

/// Lenses are centred within a few percent; images cut at one side are within a quarter.
constexpr double kOffCentre = 0.25;
// Rectified images of wider lenses are cut, since their edges would be stretched threefold.
constexpr double kWidestRectified = 115;  // degrees
constexpr double kWidestRaw = 160;        // degrees; of a lens with radial distortion
constexpr double kNarrowest = 3;          // degrees

struct Camera {
  std::string name;  ///< "" or "of the left camera "
  int width;
  int height;
  Pinhole pinhole;
};

void addCentreDoubt(const Camera& camera, std::vector<std::string>& doubts) {
  const auto isNear = [](double centre, int size) {
    return std::abs(centre / size - 0.5) <= kOffCentre;
  };
  const Pinhole& K = camera.pinhole;
  if (isNear(K.cx, camera.width) && isNear(K.cy, camera.height)) return;
  doubts.push_back(fmt::format(
      "the principal point {}({:.1f}, {:.1f}) is far from the middle of the {}x{} image; were the "
      "images resized after the calibration? Then scale fx, fy, cx, cy as well",
      camera.name, K.cx, K.cy, camera.width, camera.height));
}

void addViewDoubt(const Camera& camera, double widest, std::vector<std::string>& doubts) {
  const Pinhole& K = camera.pinhole;
  if (!(K.fx > 0) || !(K.fy > 0)) return;
  const double half = std::max(camera.width / K.fx, camera.height / K.fy) / 2;
  const double degrees = 2 * std::atan(half) * 180 / std::numbers::pi;
  if (degrees >= kNarrowest && degrees <= widest) return;
  doubts.push_back(fmt::format(
      "the focal length {}({:.1f}, {:.1f}) gives the {}x{} image a view of {:.0f} degrees, which "
      "such cameras hardly have; is it that of these images, in pixels? Depths and paths are wrong "
      "by its error",
      camera.name, K.fx, K.fy, camera.width, camera.height, degrees));
}

}  // namespace

std::vector<std::string> cameraDoubts(const CameraRig& rig) {
  std::vector<std::string> doubts;
  if (!rig.calibrated || rig.width <= 0 || rig.height <= 0) return doubts;
  const Camera camera{"", rig.width, rig.height, rig.pinhole};
  addCentreDoubt(camera, doubts);
  addViewDoubt(camera, kWidestRectified, doubts);
  return doubts;
}

std::vector<std::string> cameraDoubts(const RawRig& rig) {
  std::vector<std::string> doubts;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const RawCamera& raw = rig.cameras[i];
    if (raw.width <= 0 || raw.height <= 0) continue;
    const std::string name = rig.cameras.size() < 2 ? ""
                             : i == 0               ? "of the left camera "
                                                    : "of the right camera ";
    const Camera camera{name, raw.width, raw.height, raw.pinhole};
    addCentreDoubt(camera, doubts);
    const bool is_wide =
        raw.model == LensModel::Equidistant || raw.model == LensModel::Omnidirectional;
    if (!is_wide) addViewDoubt(camera, kWidestRaw, doubts);
    const std::string pixels = pixelDoubt(raw.pinhole, name);
    if (!pixels.empty()) doubts.push_back(pixels);
  }
  return doubts;
}

}  // namespace tolman::imaging
