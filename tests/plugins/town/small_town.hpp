// SPDX-License-Identifier: BSD-3-Clause
// A town around the built-in route `block`, and small images of it.
#pragma once

#include <memory>

#include "renderer.hpp"
#include "route.hpp"
#include "scene.hpp"
#include "street_plan.hpp"
#include "world.hpp"

namespace tolman::town::test {

/// Built once a test; everything that a Renderer points to.
struct SmallTown {
  explicit SmallTown(const Light& with_light = makeLight(10.5, Weather::Clear, 0, 5),
                     const WorldOptions& options = {}, std::string_view name = "block")
      : route(builtInRoute(name, {}).value()),
        plan(StreetPlan::grow(route, RouteOptions{}.camera_height).value()),
        scene(buildWorld(plan, options)),
        light(with_light) {}

  /// KITTI's camera at a third of its size.
  static RenderCamera view(const Eigen::Isometry3d& T_town_camera) {
    RenderCamera view;
    view.T_town_camera = T_town_camera;
    view.width = 414;
    view.height = 125;
    view.pinhole = {239.6, 239.6, 202.1, 61.4};
    return view;
  }
  RenderedImage picture(const RenderCamera& of, int edge_samples = 4) const {
    RenderedImage result;
    Renderer(scene, plan, light, edge_samples).render(of, result);
    return result;
  }

  CameraRoute route;
  StreetPlan plan;
  Scene scene;
  Light light;
};

}  // namespace tolman::town::test
