// SPDX-License-Identifier: BSD-3-Clause
// Zstandard and LZ4 frames, unpacked within a limit, whatever their headers claim.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bytes.hpp"

namespace tolman::ros_bag {

/// Whether the bytes begin as a Zstandard frame does.
bool isZstd(Bytes packed);

/// None: the data are damaged or not complete, or unpack to more than `most` bytes.
std::optional<std::vector<std::uint8_t>> unpackZstd(Bytes packed, std::size_t most);
std::optional<std::vector<std::uint8_t>> unpackLz4(Bytes packed, std::size_t most);

}  // namespace tolman::ros_bag
