// SPDX-License-Identifier: BSD-3-Clause
// Central differences of a whole level.
#include "gradient_image.hpp"

#include <tbb/parallel_for.h>

namespace tolman::direct_sparse {
namespace {

#if defined(__SSE2__)
__m128i eightShorts(const std::uint8_t* p) {
  return _mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)),
                           _mm_setzero_si128());
}

/// Stores the quads of eight pixels; reads one more pixel on either side.
void storeEight(const std::uint8_t* here, const std::uint8_t* above, const std::uint8_t* below,
                std::int16_t* out) {
  const __m128i value = eightShorts(here);
  const __m128i gx = _mm_sub_epi16(eightShorts(here + 1), eightShorts(here - 1));
  const __m128i gy = _mm_sub_epi16(eightShorts(below), eightShorts(above));
  auto* quads = reinterpret_cast<__m128i*>(out);
  const auto store = [&](__m128i first, __m128i second) {
    _mm_storeu_si128(quads++, _mm_unpacklo_epi32(first, second));
    _mm_storeu_si128(quads++, _mm_unpackhi_epi32(first, second));
  };
  const __m128i zero = _mm_setzero_si128();
  store(_mm_unpacklo_epi16(value, gx), _mm_unpacklo_epi16(gy, zero));
  store(_mm_unpackhi_epi16(value, gx), _mm_unpackhi_epi16(gy, zero));
}
#endif

}  // namespace

void GradientImage::build(const GrayLevel& image) {
  if (width_ != image.width || height_ != image.height) {
    width_ = image.width;
    height_ = image.height;
    quads_.assign(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
  }
  tbb::parallel_for(0, height_, [&](int v) {
    const bool inner = v > 0 && v < height_ - 1;
    const std::uint8_t* here = image.row(v);
    const std::uint8_t* above = inner ? image.row(v - 1) : here;
    const std::uint8_t* below = inner ? image.row(v + 1) : here;
    std::int16_t* out = quads_.data() + 4 * static_cast<std::ptrdiff_t>(v) * width_;
    out[0] = here[0];
    int u = 1;
#if defined(__SSE2__)
    for (; u + 8 < width_; u += 8) storeEight(here + u, above + u, below + u, out + 4 * u);
#endif
    for (; u < width_ - 1; ++u) {
      out[4 * u] = here[u];
      out[4 * u + 1] = static_cast<std::int16_t>(here[u + 1] - here[u - 1]);
      out[4 * u + 2] = static_cast<std::int16_t>(below[u] - above[u]);
      out[4 * u + 3] = 0;
    }
    out[4 * (width_ - 1)] = here[width_ - 1];
  });
}

}  // namespace tolman::direct_sparse
