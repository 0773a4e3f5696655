// SPDX-License-Identifier: BSD-3-Clause
// Parameters of plugins that are participants of ROS 2, the same with and without DDS in the build.
#pragma once

#include <concepts>
#include <string>

#include "tolman/parameters.hpp"

namespace tolman::source_parameters {

/// Where the other nodes are; base of the Parameters.
struct Ros2Network {
  int domain = -1;
  std::string peers;
};

template <std::derived_from<Ros2Network> P>
constexpr auto ros2Network() {
  return parameters(
      parameter<P, int>("domain", &P::domain)
          .range(-1, 230)
          .doc("Domain of DDS; -1: $ROS_DOMAIN_ID, or 0."),
      parameter<P, std::string>("peers", &P::peers)
          .doc("Computers with the other nodes where multicast does not find them: addresses or "
               "names, with commas between them; localhost: this computer only."));
}

}  // namespace tolman::source_parameters
