// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `ros1`, the same with and without ROS in the build.
#pragma once

#include <string>
#include <tuple>

#include "live_parameters.hpp"

namespace tolman::ros1 {

struct Ros1Parameters : live_images::LiveParameters {
  std::string master;

  static constexpr auto declaration();
};

constexpr auto Ros1Parameters::declaration() {
  return std::tuple_cat(parameters(parameter("master", &Ros1Parameters::master)
                                       .doc("URI of the roscore; empty: $ROS_MASTER_URI, or "
                                            "http://localhost:11311.")),
                        live_images::liveParameters<Ros1Parameters>());
}

}  // namespace tolman::ros1
