// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the pose file of a drive through the town.
#include "route.hpp"

#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  for (const double rate : {10.0, 0.001, 1e6}) {
    town::RouteOptions options;
    options.rate = rate;
    const auto route = town::readRoute(file.path(), options);
    if (!route.isOk()) continue;
    fuzz::require(route.value().T_town_camera.size() == route.value().stamps_ns.size(),
                  "poses without stamps");
    for (const Eigen::Isometry3d& pose : route.value().T_town_camera) {
      fuzz::require(pose.matrix().allFinite(), "a pose that is not finite");
    }
  }
  return 0;
}
