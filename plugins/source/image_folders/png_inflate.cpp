// SPDX-License-Identifier: BSD-3-Clause
#include "png_inflate.hpp"

#include <libdeflate.h>

#include <new>

namespace tolman::image_folders {

std::unique_ptr<std::uint8_t[]> inflatePng(std::span<const std::uint8_t> packed, std::size_t size) {
  constexpr std::size_t kMaxPerByte = 1032;  // largest ratio of deflate; limits memory
  if (size / kMaxPerByte > packed.size()) return nullptr;
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> inflater(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!inflater) throw std::bad_alloc();
  auto rows = std::make_unique_for_overwrite<std::uint8_t[]>(size);
  const libdeflate_result result =
      libdeflate_zlib_decompress(inflater.get(), packed.data(), packed.size(), rows.get(), size,
                                 nullptr);  // null: exactly `size` bytes
  if (result != LIBDEFLATE_SUCCESS) return nullptr;
  return rows;
}

}  // namespace tolman::image_folders
