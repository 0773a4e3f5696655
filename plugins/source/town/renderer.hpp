// SPDX-License-Identifier: BSD-3-Clause
// Radiance and depth of what one camera sees.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "light.hpp"
#include "scene.hpp"
#include "street_plan.hpp"
#include "tolman/camera.hpp"

namespace tolman::town {

struct View {
  Eigen::Isometry3d T_town_camera = Eigen::Isometry3d::Identity();
  Pinhole pinhole;
  int width = 0;
  int height = 0;
};

/// Row-major, width * height.
struct Picture {
  std::vector<float> radiance;
  std::vector<float> depth;  ///< m along the optical axis, at the pixel's centre; 0 for sky
};

/// One ray through the centre of each pixel, textures averaged over the pixel; where neighbours
/// show different things, a mean over `edge_samples` more rays. Rows are shared out to threads;
/// every pixel is the same whatever their number.
class Renderer {
 public:
  Renderer(const Scene& scene, const StreetPlan& plan, const Light& light, int edge_samples)
      : scene_(&scene), plan_(&plan), light_(light), edge_samples_(edge_samples) {}

  void render(const View& view, Picture& picture);

 private:
  class Rays;
  void firstPass(const Rays& rays, int first_row, int end_row, Picture& picture);
  void smoothEdges(const Rays& rays, int first_row, int end_row, Picture& picture);
  bool isEdge(const Picture& picture, const Rays& rays, int column, int row) const;

  const Scene* scene_;
  const StreetPlan* plan_;
  Light light_;
  int edge_samples_;
  std::vector<char> edges_;
  std::vector<std::uint32_t> seen_;  ///< what each pixel shows, and whether the sun is on it
};

}  // namespace tolman::town
