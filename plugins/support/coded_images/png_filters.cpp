// SPDX-License-Identifier: BSD-3-Clause
#include "png_filters.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

namespace tolman::coded_images {
namespace {

constexpr auto byte(int value) { return static_cast<std::uint8_t>(value); }

/// The one of a, b and c that is nearest to a + b - c; the first one of equally near ones.
inline int paeth(int a, int b, int c) {
  const int to_a = b - c;  // p - a, of p = a + b - c
  const int to_b = a - c;
  const int distance_a = std::abs(to_a);
  const int distance_b = std::abs(to_b);
  const int distance_c = std::abs(to_a + to_b);
  const int nearer = distance_a <= distance_b ? a : b;
  return std::min(distance_a, distance_b) <= distance_c ? nearer : c;
}

/// One row. The pixel to the left stays in registers: `N` bytes of a pixel.
template <std::size_t N, class Predict>
void undo(const std::uint8_t* in, const std::uint8_t* above, std::size_t bytes, std::uint8_t* out,
          const Predict& predict) {
  int a[N] = {};
  int c[N] = {};
  for (std::size_t i = 0; i < bytes; i += N) {
    for (std::size_t k = 0; k < N; ++k) {
      const int b = above[i + k];
      a[k] = byte(in[i + k] + predict(a[k], b, c[k]));
      c[k] = b;
      out[i + k] = static_cast<std::uint8_t>(a[k]);
    }
  }
}

/// Filter 1 of pixels of one byte, eight at once: each byte becomes the sum of all up to it. Pairs
/// of bytes are added up in lanes of 16 bits, which sums of nine bytes do not exceed.
void addUpRow(const std::uint8_t* in, std::size_t bytes, std::uint8_t* out) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::uint64_t kLanes = 0x0001000100010001;
  constexpr std::uint64_t kLowBytes = 0x00ff00ff00ff00ff;
  std::uint64_t before = 0;  // the last byte of the eight before
  std::size_t i = 0;
  for (; i + 8 <= bytes; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, in + i, sizeof word);
    const std::uint64_t second = word >> 8 & kLowBytes;
    const std::uint64_t pairs = (word & kLowBytes) + second + before;
    const std::uint64_t sums = pairs * kLanes;  // each lane: the sum of all lanes up to it
    word = ((sums - second) & kLowBytes) | (sums & kLowBytes) << 8;
    std::memcpy(out + i, &word, sizeof word);
    before = sums >> 48 & 255;
  }
  for (; i < bytes; ++i) out[i] = byte(static_cast<int>(before += in[i]));
}

template <std::size_t N>
bool undoRow(int filter, const std::uint8_t* in, const std::uint8_t* above, std::size_t bytes,
             std::uint8_t* out) {
  switch (filter) {
    case 0:
      std::copy_n(in, bytes, out);
      return true;
    case 1:
      if (N == 1) {
        addUpRow(in, bytes, out);
        return true;
      }
      undo<N>(in, above, bytes, out, [](int a, int, int) { return a; });
      return true;
    case 2:
      for (std::size_t i = 0; i < bytes; ++i) out[i] = byte(in[i] + above[i]);
      return true;
    case 3:
      undo<N>(in, above, bytes, out, [](int a, int b, int) { return (a + b) / 2; });
      return true;
    case 4:
      undo<N>(in, above, bytes, out, paeth);
      return true;
    default:
      return false;
  }
}

}  // namespace

bool undoFilters(const std::uint8_t* rows, std::size_t height, std::size_t row_bytes,
                 std::size_t pixel_bytes, std::uint8_t* pixels) {
  const std::vector<std::uint8_t> nothing(row_bytes);  // above the first row
  const std::uint8_t* above = nothing.data();
  const auto undoOne = pixel_bytes == 1 ? &undoRow<1> : &undoRow<3>;
  for (std::size_t y = 0; y < height; ++y, rows += row_bytes + 1, pixels += row_bytes) {
    if (!undoOne(rows[0], rows + 1, above, row_bytes, pixels)) return false;
    above = pixels;
  }
  return true;
}

void swapRedAndBlue(std::uint8_t* pixels, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) std::swap(pixels[3 * i], pixels[3 * i + 2]);
}

}  // namespace tolman::coded_images
