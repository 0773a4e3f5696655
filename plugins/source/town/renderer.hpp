// SPDX-License-Identifier: BSD-3-Clause
// Renders radiance and depth of one camera.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "light.hpp"
#include "scene.hpp"
#include "street_plan.hpp"
#include "tolman/camera.hpp"

namespace tolman::town {

/// Displacements, row-major, one per pixel; empty for an exact calibration.
struct PixelWarp {
  std::vector<float> x;  ///< px: the ray of pixel u is that of u + x in a perfect camera
  std::vector<float> y;

  bool isEmpty() const { return x.empty(); }
};

/// Pose, intrinsics (px) and image size (px) of the camera that is rendered.
struct RenderCamera {
  Eigen::Isometry3d T_town_camera = Eigen::Isometry3d::Identity();
  Pinhole pinhole;
  int width = 0;
  int height = 0;
  const PixelWarp* warp = nullptr;  ///< of the same size, or null
  /// Pose for each row with a rolling shutter; empty: all rows at T_town_camera.
  std::vector<Eigen::Isometry3d> T_town_rows;
};

/// Row-major, width * height.
struct RenderedImage {
  std::vector<float> radiance;
  std::vector<float> depth;  ///< m along the optical axis, at the pixel's centre; 0 for sky
  std::vector<std::uint32_t> instance;  ///< of the scene, or kNoInstance
};

/// One ray through the centre of each pixel, with textures averaged over the pixel. Where
/// neighbouring pixels differ, the mean with `edge_samples` more rays. Rows are distributed over
/// threads; the image does not depend on their number.
class Renderer {
 public:
  Renderer(const Scene& scene, const StreetPlan& plan, const Light& light, int edge_samples)
      : scene_(&scene), plan_(&plan), light_(light), edge_samples_(edge_samples) {}

  void setLight(const Light& light) { light_ = light; }
  void render(const RenderCamera& view, RenderedImage& picture);

 private:
  class Rays;
  void firstPass(const Rays& rays, int first_row, int end_row, RenderedImage& picture);
  void smoothEdges(const Rays& rays, int first_row, int end_row, RenderedImage& picture);

  const Scene* scene_;
  const StreetPlan* plan_;
  Light light_;
  int edge_samples_;
  std::vector<std::uint32_t> edges_;  ///< of each pixel: 1 where more rays are needed
  std::vector<std::uint32_t> seen_;   ///< Shaded::seen of each pixel
};

}  // namespace tolman::town
