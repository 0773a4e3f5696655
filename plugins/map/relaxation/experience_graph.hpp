// SPDX-License-Identifier: BSD-3-Clause
// RatSLAM's experience map: experiences joined by links in polar form, and its relaxation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tolman/geometry.hpp"

namespace tolman::relaxation {

/// Pose of `to` relative to `from` in polar form.
struct PolarLink {
  std::int64_t from = -1;
  std::int64_t to = -1;
  double distance = 0;  ///< m
  double heading = 0;   ///< rad, direction of `to` against the heading of `from`
  double facing = 0;    ///< rad, heading of `to` against the heading of `from`
  double climb = 0;     ///< m, of `to` above `from`
  double seconds = 0;   ///< travel time
  bool loop = false;
  std::int64_t frame = -1;
};

PlanarPose toPlanar(const PolarLink& link);

class ExperienceGraph {
 public:
  std::int64_t size() const { return static_cast<std::int64_t>(experiences_.size()); }
  const PlanarPose& operator[](std::int64_t id) const {
    return experiences_[static_cast<std::size_t>(id)];
  }
  const std::vector<PolarLink>& links() const { return links_; }

  double height(std::int64_t id) const { return heights_[static_cast<std::size_t>(id)]; }

  std::int64_t add(const PlanarPose& pose, double height = 0);
  /// Links two experiences with the motion that odometry measured between them; `seconds`: travel
  /// time, `climb`: m. False when they are linked already, in either direction.
  bool link(std::int64_t from, std::int64_t to, const PlanarPose& measured, double seconds,
            std::int64_t frame, bool loop, double climb = 0);
  /// In each sweep both ends of each link move by the share `correction` of its residual; 0.5 for
  /// each end removes the residual.
  void relax(int sweeps, double correction);

 private:
  bool joined(std::int64_t a, std::int64_t b) const;

  std::vector<PlanarPose> experiences_;
  std::vector<double> heights_;  ///< m
  std::vector<PolarLink> links_;
  std::vector<std::vector<std::int64_t>> neighbours_;
};

}  // namespace tolman::relaxation
