// SPDX-License-Identifier: BSD-3-Clause
// The velocity that is assumed while tracking is lost. The last frame before a loss is often
// disturbed already (blurred, partly covered), so its velocity alone is not trusted.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "tolman/geometry.hpp"

namespace tolman {

/// The last three measured velocities (m/s, rad/s), in order of time.
class RecentVelocities {
 public:
  void clear() { count_ = 0; }
  void add(const Vector6d& velocity) { velocities_[count_++ % velocities_.size()] = velocity; }
  /// The median of each component; of one or two velocities the last one, of none zero.
  Vector6d median() const {
    if (count_ == 0) return Vector6d::Zero();
    if (count_ < velocities_.size()) return velocities_[count_ - 1];
    Vector6d median;
    for (Eigen::Index i = 0; i < median.size(); ++i) {
      const auto [a, b, c] = std::array{velocities_[0][i], velocities_[1][i], velocities_[2][i]};
      median[i] = std::max(std::min(a, b), std::min(std::max(a, b), c));
    }
    return median;
  }

 private:
  std::array<Vector6d, 3> velocities_;
  std::size_t count_ = 0;  ///< of all that were added
};

}  // namespace tolman
