// SPDX-License-Identifier: BSD-3-Clause
// Visits the messages of a bag, and reads some of them again. `checked`: the format has checksums
// or reliable places, so a message that is read again is the same. Otherwise it has the same size,
// or is refused.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bag.hpp"
#include "input.hpp"

namespace tolman::fuzz {

inline void readMessages(ros_bag::BagFile& bag, bool checked) {
  using Visited = std::pair<ros_bag::MessagePlace, std::vector<std::uint8_t>>;
  std::vector<Visited> visited;
  bool is_damaged = false;
  bag.visit(
      [&](const ros_bag::Topic&, std::int64_t, const ros_bag::MessagePlace& place,
          ros_bag::Bytes bytes) {
        require(place.size == bytes.size(), "a message of another size than its place says");
        if (visited.size() < 50)
          visited.emplace_back(place, std::vector(bytes.begin(), bytes.end()));
      },
      [&](const std::string&) { is_damaged = true; });
  if (is_damaged) return;
  for (const auto& [place, bytes] : visited) {
    const auto again = bag.read(place);
    require(again.isOk() || !checked, "a message that cannot be read again");
    if (!again.isOk()) continue;
    require(again.value().size() == bytes.size(), "a message that changes its size");
    require(!checked || again.value() == bytes, "a message that changes");
  }
}

}  // namespace tolman::fuzz
