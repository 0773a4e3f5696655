// SPDX-License-Identifier: BSD-3-Clause
// Source `town`: renders calibrated images, true poses and depth along a route through a procedural
// town. Axes: see world.hpp. The same parameters and seeds give the same bytes.
//
// Of each frame: the route and how the camera is carried along it give its pose (`setMotion`), the
// rig its cameras (`setRig`), conditions and traffic the scene (`arrange`); each camera renders and
// forms its image (camera.hpp).
#pragma once

#include <memory>
#include <vector>

#include "camera.hpp"
#include "conditions.hpp"
#include "objects.hpp"
#include "parameters.hpp"
#include "renderer.hpp"
#include "route.hpp"
#include "scene.hpp"
#include "street_plan.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "traffic.hpp"

namespace tolman::town {

class TownSource final : public Source, public ArrayDescriptions {
 public:
  using Parameters = TownParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status next(Frame& frame) override;
  /// Describes depth.left, if `depth` is set.
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  Status setRig();
  /// The streets below the route, and the poses of the camera.
  Status setRoute();
  Status setMotion(const CameraRoute& carried);
  Status setConditions(const Context& context);
  void buildScene();
  Status build(const Context& context);

  /// Time since the start of the drive, s.
  double secondsAt(std::size_t index) const;
  /// Time to the next pose of the route, s.
  double intervalAt(std::size_t index) const;
  /// `part` of the interval after pose `index` of the route; before it if negative.
  Traffic::Instant instantAt(std::size_t index, double part) const;
  /// Sets traffic, season and light.
  void arrange(std::size_t index);
  Image takePicture(std::size_t index, std::size_t camera);
  /// Grey levels for a radiance of 1.
  double gainAt(std::size_t index) const;

  Parameters parameters_;
  std::uint32_t run_seed_ = 0;
  Status ready_ = Status::failed("configure() was not called");
  CameraRig rig_;
  CameraRoute route_;  ///< of a vehicle on the streets
  std::vector<Eigen::Isometry3d> T_town_camera_;
  bool is_levelled_ = false;
  std::unique_ptr<StreetPlan> plan_;
  Conditions conditions_;
  Light light_;  ///< at the current frame
  Exchange trees_;
  Exchange cars_;
  Condition shown_;
  Traffic traffic_;
  std::unique_ptr<Scene> scene_;
  std::vector<TownCamera> cameras_;  ///< left, right
  std::vector<Renderer> renderers_;  ///< one for each camera, so that both render in parallel
  FrameSequence sequence_;
  std::vector<std::int64_t> arriving_;  ///< frames of the sequence that are not missing
  std::size_t next_ = 0;
};

}  // namespace tolman::town
