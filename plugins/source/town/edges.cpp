// SPDX-License-Identifier: BSD-3-Clause
#include "edges.hpp"

#include <algorithm>
#include <cmath>

#include "ray_packet.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

/// Contrast below the noise of the camera, which is not smoothed: relative, and absolute radiance.
constexpr float kFaint = 0.04F;
constexpr float kDim = 0.012F;

/// A row, with pointers to each pixel's neighbours in one direction.
struct Neighbours {
  const float* radiance[3];  // before, here, after
  const float* depth[3];
  const std::uint32_t* seen[3];
};

[[gnu::always_inline]] inline float inverseOf(float depth) { return depth > 0 ? 1 / depth : 0.0F; }

/// Without branches, so that loops over it are vectorised.
[[gnu::always_inline]] inline std::uint32_t differs(const Neighbours& of, int before, int here,
                                                    int after) {
  const float radiance = of.radiance[1][here];
  const float contrast = std::max(std::abs(of.radiance[0][before] - radiance),
                                  std::abs(of.radiance[2][after] - radiance));
  const std::uint32_t seen = of.seen[1][here];
  const std::uint32_t change = (of.seen[0][before] ^ seen) | (of.seen[2][after] ^ seen);
  // Inverse depth is linear over the image of a plane, so its second difference shows edges.
  const float inverse = inverseOf(of.depth[1][here]);
  const float bend = inverseOf(of.depth[0][before]) - 2 * inverse + inverseOf(of.depth[2][after]);
  const std::uint32_t bends = std::abs(bend) > 0.02F * inverse ? 1 : 0;
  const std::uint32_t has_faces = (seen & kFoliage) != 0 ? 0 : 1;
  const std::uint32_t is_visible = contrast < std::max(kDim, kFaint * radiance) ? 0 : 1;
  return is_visible & ((change != 0 ? 1U : 0U) | (bends & has_faces));
}

TOLMAN_WIDE_LANES
void findInRow(const Neighbours& beside, const Neighbours& above, int width, std::uint32_t* edges) {
  const Neighbours b = beside;
  const Neighbours a = above;
  for (int c = 1; c < width - 1; ++c) {
    edges[c] = differs(b, c - 1, c, c + 1) | differs(a, c, c, c);
  }
  for (const int c : {0, width - 1}) {
    edges[c] = differs(b, std::max(c - 1, 0), c, std::min(c + 1, width - 1)) | differs(a, c, c, c);
  }
}

}  // namespace

void findEdges(const FirstLook& look, int row, std::uint32_t* edges) {
  const auto at = [&](int r) {
    return static_cast<std::size_t>(std::clamp(r, 0, look.height - 1)) *
           static_cast<std::size_t>(look.width);
  };
  const auto rows = [&](int reach) {
    Neighbours of = {};
    for (int i = 0; i < 3; ++i) {
      const std::size_t first = at(row + reach * (i - 1));
      of.radiance[i] = look.radiance.data() + first;
      of.depth[i] = look.depth.data() + first;
      of.seen[i] = look.seen.data() + first;
    }
    return of;
  };
  findInRow(rows(0), rows(1), look.width, edges);
}

}  // namespace tolman::town
