// SPDX-License-Identifier: BSD-3-Clause
// Placements of the instances that eight rays meet.
#pragma once

#include <array>

#include "lanes.hpp"

namespace tolman::town {

/// Fixed geometry has the identity.
struct Placements {
  alignas(32) std::array<float, kLanes> cosine, sine, scale, lean_x, lean_y, x, y, z;

  void set(std::size_t i, const Placement& p) {
    cosine[i] = p.cosine;
    sine[i] = p.sine;
    scale[i] = p.scale;
    lean_x[i] = p.lean_x;
    lean_y[i] = p.lean_y;
    x[i] = p.position.x;
    y[i] = p.position.y;
    z[i] = p.position.z;
  }
  TOLMAN_INLINE Vec3s rotate(const Vec3s& v) const {
    const Eight c = loadEight(cosine.data());
    const Eight s = loadEight(sine.data());
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
  }
  TOLMAN_INLINE Vec3s unrotate(const Vec3s& v) const {
    const Eight c = loadEight(cosine.data());
    const Eight s = loadEight(sine.data());
    return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
  }
  TOLMAN_INLINE Eight shrinking() const { return 1 / loadEight(scale.data()); }
  TOLMAN_INLINE Vec3s toLocal(const Vec3s& town) const {
    const Vec3s leaning =
        town - Vec3s{loadEight(x.data()), loadEight(y.data()), loadEight(z.data())};
    const Vec3s upright = {leaning.x - loadEight(lean_x.data()) * leaning.z,
                           leaning.y - loadEight(lean_y.data()) * leaning.z, leaning.z};
    return unrotate(upright) * shrinking();
  }
};

}  // namespace tolman::town
