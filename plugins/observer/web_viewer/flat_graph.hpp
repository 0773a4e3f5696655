// SPDX-License-Identifier: BSD-3-Clause
// The experience graph as the page draws it: a tenth of the map's own size.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::web_viewer {

struct FlatGraph {
  std::int64_t version = 0;
  std::int64_t frame = -1;        ///< as known at this frame; -1 after the last
  std::vector<float> experience;  ///< x, y, z, yaw of each
  std::vector<std::int32_t> experience_frame;
  std::vector<std::int32_t> experience_template;
  std::vector<std::int32_t> link;  ///< from, to of each
  std::vector<std::uint8_t> link_kind;
  std::vector<float> link_weight;

  void take(const MapGraph& graph, std::int64_t at_frame);
  std::string encode() const;
};

}  // namespace tolman::web_viewer
