// SPDX-License-Identifier: BSD-3-Clause
#include "experience_graph.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::relaxation {

PlanarPose toPlanar(const PolarLink& link) {
  return {link.distance * std::cos(link.heading), link.distance * std::sin(link.heading),
          link.facing};
}

std::int64_t ExperienceGraph::add(const PlanarPose& pose, double height) {
  experiences_.push_back(pose);
  heights_.push_back(height);
  neighbours_.emplace_back();
  return size() - 1;
}

bool ExperienceGraph::joined(std::int64_t a, std::int64_t b) const {
  const std::vector<std::int64_t>& of_a = neighbours_[static_cast<std::size_t>(a)];
  return std::ranges::find(of_a, b) != of_a.end();
}

bool ExperienceGraph::link(std::int64_t from, std::int64_t to, const PlanarPose& measured,
                           double seconds, std::int64_t frame, bool loop, double climb) {
  if (from == to || joined(from, to)) return false;
  links_.push_back({from, to, std::hypot(measured.x, measured.y),
                    std::atan2(measured.y, measured.x), measured.theta, climb, seconds, loop,
                    frame});
  neighbours_[static_cast<std::size_t>(from)].push_back(to);
  neighbours_[static_cast<std::size_t>(to)].push_back(from);
  return true;
}

void ExperienceGraph::relax(int sweeps, double correction) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const PolarLink& link : links_) {
      PlanarPose& from = experiences_[static_cast<std::size_t>(link.from)];
      PlanarPose& to = experiences_[static_cast<std::size_t>(link.to)];
      const double x = from.x + link.distance * std::cos(from.theta + link.heading);
      const double y = from.y + link.distance * std::sin(from.theta + link.heading);
      const double off_x = correction * (to.x - x);
      const double off_y = correction * (to.y - y);
      const double off_theta = correction * wrapAngle(to.theta - from.theta - link.facing);
      from = {from.x + off_x, from.y + off_y, wrapAngle(from.theta + off_theta)};
      to = {to.x - off_x, to.y - off_y, wrapAngle(to.theta - off_theta)};
      double& from_height = heights_[static_cast<std::size_t>(link.from)];
      double& to_height = heights_[static_cast<std::size_t>(link.to)];
      const double off_height = correction * (to_height - from_height - link.climb);
      from_height += off_height;
      to_height -= off_height;
    }
  }
}

}  // namespace tolman::relaxation
