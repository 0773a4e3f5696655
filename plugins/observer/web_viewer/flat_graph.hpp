// SPDX-License-Identifier: BSD-3-Clause
// The experience graph in flat arrays for the page: a tenth of the size of a MapGraph.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "wire_records.hpp"

namespace tolman::web_viewer {

struct FlatGraph {
  GraphHeader header;
  std::vector<float> experience;   ///< x, y, z (m) and yaw (rad) of each experience
  std::vector<std::int32_t> link;  ///< from, to of each link
  std::vector<std::uint8_t> link_kind;
  std::vector<std::uint8_t> link_rejected;  ///< 1: loop link that the map has rejected
  std::vector<float> link_metres;           ///< length of each; not encoded
  std::vector<float> link_seconds;          ///< travel time of each, 0 for a loop link; not encoded

  /// `at_frame`: the graph is the one after this frame; -1 for the final one.
  void assign(const MapGraph& graph, std::int64_t at_frame);
  std::string encode() const;
};

}  // namespace tolman::web_viewer
