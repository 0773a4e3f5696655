// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pixel_groups.hpp"

#include <algorithm>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace tolman::engine {
namespace {

constexpr int kGroup = 8;
constexpr int kColumns = 16;         // most columns of the raw image for one group
constexpr int kMaxRows = 8;          // with more rows, one pixel at a time is faster
constexpr std::uint8_t kNone = 128;  // a column with the value 0

template <int Channels>
void interpolatePositions(const Image& raw, std::span<const RawPosition> positions,
                          std::uint8_t* out) {
  const std::uint8_t* const data = raw.data();
  const std::ptrdiff_t stride = raw.stride();
  for (const RawPosition& position : positions) {
    if (position.right != RawPosition::kNowhere) {
      const std::uint8_t* above = data + position.y * stride + position.x * Channels;
      const std::uint8_t* below = above + stride;
      for (int k = 0; k < Channels; ++k) {
        const int upper =
            above[k] * (kParts - position.right) + above[k + Channels] * position.right;
        const int lower =
            below[k] * (kParts - position.right) + below[k + Channels] * position.right;
        const int down = ((lower - upper) * position.below + kParts / 2) >> 6;
        out[k] = static_cast<std::uint8_t>((upper + down + kParts / 2) >> 6);
      }
    }
    out += Channels;
  }
}

#ifdef __x86_64__

[[gnu::target("sse4.1")]] inline __m128i load8(const std::uint8_t* from) {
  return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(from));
}

[[gnu::target("sse4.1")]] inline __m128i load16(const std::uint8_t* from) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

/// Selects the pairs of columns from each raw row, and keeps them in the lanes that use this row.
[[gnu::target("sse4.1")]] inline __m128i interpolateGroup(const PixelGroup& group,
                                                          const std::uint8_t* row,
                                                          std::ptrdiff_t stride) {
  const __m128i columns = load8(group.column);
  const __m128i pairs = _mm_unpacklo_epi8(columns, _mm_add_epi8(columns, _mm_set1_epi8(1)));
  const __m128i rows = _mm_unpacklo_epi8(load8(group.row), load8(group.row));
  __m128i above = _mm_shuffle_epi8(load16(row), pairs);
  __m128i below = _mm_shuffle_epi8(load16(row += stride), pairs);
  __m128i last = below;
  for (std::uint32_t r = 1; r < group.rows; ++r) {
    const __m128i next = _mm_shuffle_epi8(load16(row += stride), pairs);
    const __m128i here = _mm_cmpeq_epi8(rows, _mm_set1_epi8(static_cast<char>(r)));
    above = _mm_blendv_epi8(above, last, here);
    below = _mm_blendv_epi8(below, next, here);
    last = next;
  }
  const __m128i right = load8(group.right);
  const __m128i shares = _mm_unpacklo_epi8(_mm_sub_epi8(_mm_set1_epi8(kParts), right), right);
  const __m128i upper = _mm_maddubs_epi16(above, shares);
  const __m128i lower = _mm_maddubs_epi16(below, shares);
  // The product of mulhrs is divided by 2^15 and rounded: 2 * difference * (share * 2^8).
  const __m128i share = _mm_unpacklo_epi8(_mm_setzero_si128(), load8(group.below));
  const __m128i difference = _mm_sub_epi16(lower, upper);
  const __m128i down = _mm_mulhrs_epi16(_mm_add_epi16(difference, difference), share);
  const __m128i sum = _mm_add_epi16(_mm_add_epi16(upper, down), _mm_set1_epi16(kParts / 2));
  return _mm_packus_epi16(_mm_srai_epi16(sum, 6), _mm_setzero_si128());
}

[[gnu::target("sse4.1")]] void interpolateGroups(const Image& raw,
                                                 std::span<const RawPosition> positions,
                                                 const PixelGroup* group, std::uint8_t* out) {
  const std::size_t whole = positions.size() / kGroup * kGroup;
  for (std::size_t at = 0; at < whole; at += kGroup, ++group, out += kGroup) {
    if (group->rows == 0) {
      interpolatePositions<1>(raw, positions.subspan(at, kGroup), out);
      continue;
    }
    const __m128i pixels = interpolateGroup(*group, raw.row(group->y) + group->x, raw.stride());
    _mm_storel_epi64(reinterpret_cast<__m128i*>(out), pixels);
  }
  interpolatePositions<1>(raw, positions.subspan(whole), out);
}

#endif

PixelGroup groupOf(std::span<const RawPosition> positions, int raw_width) {
  int x = raw_width;
  int y = 65536;
  int x_end = 0;
  int y_end = 0;
  for (const RawPosition& position : positions) {
    if (position.right == RawPosition::kNowhere) continue;
    x = std::min<int>(x, position.x);
    y = std::min<int>(y, position.y);
    x_end = std::max(x_end, position.x + 2);
    y_end = std::max(y_end, position.y + 1);
  }
  x = std::max(0, std::min(x, raw_width - kColumns));
  PixelGroup group;
  if (x_end <= x || x_end - x > kColumns || x + kColumns > raw_width || y_end - y > kMaxRows) {
    return group;
  }
  group.x = static_cast<std::uint16_t>(x);
  group.y = static_cast<std::uint16_t>(y);
  group.rows = static_cast<std::uint32_t>(y_end - y);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const RawPosition& position = positions[i];
    const bool nowhere = position.right == RawPosition::kNowhere;
    group.column[i] = nowhere ? kNone : static_cast<std::uint8_t>(position.x - x);
    group.row[i] = nowhere ? std::uint8_t{0} : static_cast<std::uint8_t>(position.y - y);
    group.right[i] = nowhere ? std::uint8_t{0} : position.right;
    group.below[i] = position.below;
  }
  return group;
}

}  // namespace

void groupPositions(std::span<const RawPosition> positions, int raw_width, PixelGroup* groups) {
  for (; positions.size() >= kGroup; positions = positions.subspan(kGroup)) {
    *groups++ = groupOf(positions.first(kGroup), raw_width);
  }
}

bool hasGroupInstructions() {
#ifdef __x86_64__
  return __builtin_cpu_supports("sse4.1");
#else
  return false;
#endif
}

void interpolateRow(const Image& raw, std::span<const RawPosition> positions,
                    [[maybe_unused]] const PixelGroup* groups, std::uint8_t* out) {
  if (raw.format() != PixelFormat::Gray8) return interpolatePositions<3>(raw, positions, out);
#ifdef __x86_64__
  if (groups != nullptr) return interpolateGroups(raw, positions, groups, out);
#endif
  interpolatePositions<1>(raw, positions, out);
}

}  // namespace tolman::engine
