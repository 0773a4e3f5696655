// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `ros2`, the same with and without DDS in the build.
#pragma once

#include <tuple>

#include "live_parameters.hpp"
#include "ros2_network.hpp"

namespace tolman::ros2 {

struct Ros2Parameters : source_parameters::Ros2Network, live_images::LiveParameters {
  bool reliable = false;

  static constexpr auto declaration();
};

constexpr auto Ros2Parameters::declaration() {
  return std::tuple_cat(
      source_parameters::ros2Network<Ros2Parameters>(),
      parameters(parameter("reliable", &Ros2Parameters::reliable)
                     .doc("Images that were lost are sent again, if their publisher is reliable, "
                          "too; otherwise they are those of best effort, as of a sensor.")),
      live_images::liveParameters<Ros2Parameters>());
}

}  // namespace tolman::ros2
