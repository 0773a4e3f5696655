// SPDX-License-Identifier: BSD-3-Clause
// Decompression of Zstandard and LZ4 frames and bzip2 streams, with a limit that does not depend on
// the size in their headers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bytes.hpp"

namespace tolman::ros_bag {

using ros_messages::Bytes;

/// Whether the bytes begin as a Zstandard frame does.
bool isZstd(Bytes packed);

/// Empty if the data are damaged, incomplete or larger than `most` bytes.
std::optional<std::vector<std::uint8_t>> unpackZstd(Bytes packed, std::size_t most);
std::optional<std::vector<std::uint8_t>> unpackLz4(Bytes packed, std::size_t most);
std::optional<std::vector<std::uint8_t>> unpackBz2(Bytes packed, std::size_t most);

}  // namespace tolman::ros_bag
