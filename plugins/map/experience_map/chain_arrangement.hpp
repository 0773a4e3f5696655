// SPDX-License-Identifier: BSD-3-Clause
// The parts of the robot's path between gaps, where tracking restarted at an unknown pose, and
// which of them are joined by loops.
#pragma once

#include <cstddef>
#include <vector>

namespace tolman::experience_map {

class PathParts {
 public:
  /// `begins`: the anchor at which each part begins, ascending from 0.
  explicit PathParts(std::vector<std::size_t> begins);

  std::size_t count() const { return begins_.size(); }
  std::size_t of(std::size_t anchor) const;
  void join(std::size_t part, std::size_t other);
  bool joined(std::size_t part, std::size_t other) const { return first(part) == first(other); }
  /// The earliest part that this one is joined with; itself when there is none earlier.
  std::size_t first(std::size_t part) const { return first_[part]; }

 private:
  std::vector<std::size_t> begins_;
  std::vector<std::size_t> first_;
};

}  // namespace tolman::experience_map
