// SPDX-License-Identifier: BSD-3-Clause
// An hour without images: what an odometry answers at the first frame after it.
#pragma once

#include <vector>

#include "support/street_scene.hpp"

namespace tolman::test {

/// Tracks the first four frames, and then one that is an hour later and at another place.
template <class Host>
Motion afterAnHour(Host& host, const std::vector<Frame>& frames) {
  for (std::size_t k = 0; k < 4; ++k) host.track(frames[k]);
  Frame later = streetFrame(4, Eigen::Isometry3d(Eigen::Translation3d(2, 0, 31)) *
                                   Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitY()));
  later.stamp_ns += 3'600'000'000'000;
  return host.track(later);
}

}  // namespace tolman::test
