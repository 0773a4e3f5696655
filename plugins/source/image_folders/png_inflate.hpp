// SPDX-License-Identifier: BSD-3-Clause
// Inflates the data of a PNG file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace tolman::image_folders {

/// Exactly `size` bytes; null if the data are damaged or give another size. `packed` is the data of
/// all IDAT chunks. Throws std::bad_alloc.
std::unique_ptr<std::uint8_t[]> inflatePng(std::span<const std::uint8_t> packed, std::size_t size);

}  // namespace tolman::image_folders
