// SPDX-License-Identifier: BSD-3-Clause
// Source `ros2`: images of one camera or a pair, live from topics of ROS 2.
#pragma once

#include "live_source.hpp"
#include "ros2_parameters.hpp"

namespace tolman::ros2 {

class Ros2Source final : public live_images::LiveImageSource {
 public:
  using Parameters = Ros2Parameters;

  Status configure(const Context& context) override;
};

}  // namespace tolman::ros2
