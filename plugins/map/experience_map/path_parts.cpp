// SPDX-License-Identifier: BSD-3-Clause
#include "path_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tolman::experience_map {

PathParts::PathParts(std::vector<std::size_t> begins)
    : begins_(std::move(begins)), first_(begins_.size()) {
  std::iota(first_.begin(), first_.end(), 0);
}

std::size_t PathParts::of(std::size_t anchor) const {
  const auto next = std::ranges::upper_bound(begins_, anchor);
  return static_cast<std::size_t>(next - begins_.begin()) - 1;
}

/// Linear in the number of parts, of which there are few.
void PathParts::join(std::size_t part, std::size_t other) {
  const auto [least, most] = std::minmax(first_[part], first_[other]);
  std::ranges::replace(first_, std::size_t{most}, std::size_t{least});
}

}  // namespace tolman::experience_map
