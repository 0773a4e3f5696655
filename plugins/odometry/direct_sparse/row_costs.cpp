// SPDX-License-Identifier: BSD-3-Clause
// Eight pixels at once where the processor has SSE4.1, one after the other otherwise. Both give
// the same whole numbers.
#include "row_costs.hpp"

#include <cstdlib>

#if defined(__x86_64__)
#include <smmintrin.h>
#endif

namespace tolman::direct_sparse {
namespace {

const std::uint8_t* cornerAt(const GrayLevel& image, int u, int v) {
  return image.row(v - kPatchHeight / 2) + u - kPatchWidth / 2;
}

void costsOneByOne(const StereoPatch& patch, const GrayLevel& image, int u_begin, int u_end, int v,
                   std::uint16_t* costs) {
  for (int u = u_begin; u < u_end; ++u) {
    int sum = 0;
    for (int y = 0; y < kPatchHeight; ++y) {
      const std::uint8_t* row = cornerAt(image, u, v) + y * image.width;
      for (int x = 0; x < kPatchWidth; ++x) {
        sum += std::abs(row[x] - patch[static_cast<std::size_t>(y * kPatchWidth + x)]);
      }
    }
    *costs++ = static_cast<std::uint16_t>(sum);
  }
}

#if defined(__x86_64__)
[[gnu::target("sse4.1")]] void costsByEight(const StereoPatch& patch, const GrayLevel& image,
                                            int u_begin, int u_end, int v, std::uint16_t* costs) {
  __m128i rows[kPatchHeight];  // NOLINT: std::array ignores attributes of its type
  for (std::size_t y = 0; y < kPatchHeight; ++y) {
    rows[y] = _mm_loadl_epi64(
        reinterpret_cast<const __m128i*>(patch.data() + y * std::size_t{kPatchWidth}));
  }
  for (int u = u_begin; u < u_end; u += 8, costs += 8) {
    const std::uint8_t* p = cornerAt(image, u, v);
    __m128i sum = _mm_setzero_si128();
    for (const __m128i& row : rows) {
      const __m128i pixels = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
      // Four columns of the patch at eight places: columns 0 to 3, then 4 to 7.
      sum = _mm_add_epi16(sum, _mm_mpsadbw_epu8(pixels, row, 0b000));
      sum = _mm_add_epi16(sum, _mm_mpsadbw_epu8(pixels, row, 0b101));
      p += image.width;
    }
    _mm_storeu_si128(reinterpret_cast<__m128i*>(costs), sum);
  }
}
#endif

}  // namespace

void rowCosts(const StereoPatch& patch, const GrayLevel& image, int u_begin, int u_end, int v,
              std::uint16_t* costs) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("sse4.1")) {
    return costsByEight(patch, image, u_begin, u_end, v, costs);
  }
#endif
  costsOneByOne(patch, image, u_begin, u_end, v, costs);
}

}  // namespace tolman::direct_sparse
