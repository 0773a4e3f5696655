// SPDX-License-Identifier: BSD-3-Clause
// Source `town`: renders calibrated images, true poses and depth along a route through a procedural
// town. Axes: see mesh.hpp. The same parameters and seeds give the same bytes.
#pragma once

#include <memory>
#include <vector>

#include "condition_schedule.hpp"
#include "moving_things.hpp"
#include "renderer.hpp"
#include "route.hpp"
#include "scene.hpp"
#include "seasons.hpp"
#include "street_plan.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "town_camera.hpp"
#include "town_parameters.hpp"

namespace tolman::town {

class TownSource final : public Source, public ArrayDescriptions {
 public:
  using Parameters = TownParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status next(Frame& frame) override;
  Status inspect(std::vector<Finding>& findings) override;
  /// Describes depth.left, if `depth` is set.
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  Status build();
  /// Places the cameras along `flown`, or along the route of the streets.
  Status placeCameras(const CameraRoute& flown);
  Status setRig();
  void chooseFrames();
  /// Builds the scene from streets, seasons and traffic.
  void buildScene();
  /// Time since the start of the drive, s.
  double secondsAt(std::size_t index) const;
  /// Time to the next pose of the route, s.
  double intervalAt(std::size_t index) const;
  /// `part` of the interval after pose `index` of the route; before it if negative.
  MovingThings::Instant instantAt(std::size_t index, double part) const;
  /// Sets the traffic and the objects of season and day.
  void arrangeScene(std::size_t index);
  void setLight(std::size_t index);
  Image takePicture(std::size_t index, bool right);
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
  ConditionSchedule schedule_;
  Light light_;  ///< at the current frame
  Exchange trees_;
  Exchange cars_;
  Condition shown_;
  std::unique_ptr<MovingThings> moving_;
  std::unique_ptr<Scene> scene_;
  std::vector<TownCamera> cameras_;  ///< left, right
  std::vector<Renderer> renderers_;  ///< one for each camera, so that both render in parallel
  FrameSequence sequence_;
  std::vector<std::int64_t> arriving_;  ///< frames of the sequence that are not dropped
  std::size_t next_ = 0;
};

}  // namespace tolman::town
