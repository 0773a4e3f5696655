// SPDX-License-Identifier: BSD-3-Clause
// The filters that PNG applies to each row before compression: a byte is stored as its difference
// to a prediction from the bytes to the left (a), above (b) and above left (c) of it
// (ISO/IEC 15948, section 9.2).
#pragma once

#include <cstddef>
#include <cstdint>

namespace tolman::coded_images {

/// Writes the bytes of all rows to `pixels`, without gaps. `rows` has, for each row, the number of
/// its filter and `row_bytes` filtered bytes; the byte to the left is `pixel_bytes` away.
/// False for a filter that does not exist.
bool undoFilters(const std::uint8_t* rows, std::size_t height, std::size_t row_bytes,
                 std::size_t pixel_bytes, std::uint8_t* pixels);

/// RGB to BGR.
void swapRedAndBlue(std::uint8_t* pixels, std::size_t count);

}  // namespace tolman::coded_images
