// SPDX-License-Identifier: BSD-3-Clause
// Where something stands, seen from above.
#pragma once

#include <Eigen/Core>

#include "vec3.hpp"

namespace tolman::town::test {

inline Eigen::Vector2d placeOf(const Placement& p) {
  return {static_cast<double>(p.position.x), static_cast<double>(p.position.y)};
}

}  // namespace tolman::town::test
