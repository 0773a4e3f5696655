// SPDX-License-Identifier: BSD-3-Clause
// Source `ros1`: images of one camera or a pair, live from topics of ROS 1.
#pragma once

#include "live_source.hpp"
#include "ros1_parameters.hpp"

namespace tolman::ros1 {

class Ros1Source final : public live_images::LiveImageSource {
 public:
  using Parameters = Ros1Parameters;

  Status configure(const Context& context) override;
};

}  // namespace tolman::ros1
