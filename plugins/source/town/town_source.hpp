// SPDX-License-Identifier: BSD-3-Clause
// Source `town`: drives a route through the town and gives what the cameras see.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "renderer.hpp"
#include "route.hpp"
#include "scene.hpp"
#include "sensor.hpp"
#include "street_plan.hpp"
#include "tolman/roles.hpp"
#include "town_parameters.hpp"
#include "traffic.hpp"

namespace tolman::town {

class TownSource final : public Source {
 public:
  using Parameters = TownParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status next(Frame& frame) override;
  Status inspect(std::vector<Finding>& findings) override;

 private:
  Status build();
  Status setRig();
  void chooseFrames();
  /// The left camera `part` of the way from route pose `index` to the next.
  Eigen::Isometry3d poseAt(std::size_t index, double part) const;
  Eigen::Isometry3d rightOf(const Eigen::Isometry3d& T_town_left) const;
  void moveTraffic(std::size_t index);
  /// One camera with all that its pictures need, so that both can work at the same time.
  struct Camera {
    std::unique_ptr<Renderer> renderer;
    Picture picture;
    std::vector<float> blurred;
  };
  Image take(std::size_t index, bool right);
  double gainAt(std::size_t index) const;

  Parameters parameters_;
  std::uint32_t run_seed_ = 0;
  Status ready_ = Status::failed("configure() was not called");
  CameraRig rig_;
  Route route_;
  std::unique_ptr<StreetPlan> plan_;
  Light light_;
  std::unique_ptr<Traffic> traffic_;
  std::size_t first_traffic_ = 0;  ///< instance of the first moving car
  std::unique_ptr<Scene> scene_;
  std::array<Camera, 2> cameras_;  ///< left, right
  FrameSequence sequence_;
  std::vector<std::int64_t> arriving_;  ///< frames of the sequence that are not dropped
  std::size_t next_ = 0;
};

}  // namespace tolman::town
