// SPDX-License-Identifier: BSD-3-Clause
// Frames from messages of several topics, joined by their stamps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bag.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// Messages of one frame, as indices into the topics' lists.
struct FrameRow {
  std::size_t left = 0;
  std::size_t right = 0;             ///< of a pair
  std::optional<std::size_t> depth;  ///< the nearest within the tolerance
};

struct FrameTable {
  std::vector<FrameRow> rows;  ///< by the stamp of the left image
  std::size_t left_alone = 0;  ///< left images without a right one; they are no frames
};

/// Each message of `left` with the one of `others` whose stamp is the nearest, if within the
/// tolerance; none is used twice. Both are sorted by stamp.
std::vector<std::optional<std::size_t>> matchStamps(const std::vector<BagMessage>& left,
                                                    const std::vector<BagMessage>& others,
                                                    std::int64_t tolerance_ns);

/// InvalidInput when no left image has a right one: the message says how far they are apart.
Result<FrameTable> makeFrameTable(const BagTopic& left, const BagTopic* right,
                                  const BagTopic* depth, std::int64_t tolerance_ns);

}  // namespace tolman::ros_bag
