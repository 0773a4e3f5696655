// SPDX-License-Identifier: BSD-3-Clause
// Slots of the active window.
#include "window.hpp"

#include <catch2/catch.hpp>

using namespace tolman::direct_sparse;

namespace {

void add(Window& window, std::int64_t frame) { window.add().frame = frame; }

}  // namespace

TEST_CASE("slots of the window are used again, residuals to a removed keyframe forgotten") {
  Window window;
  add(window, 0);
  add(window, 2);
  Point point;
  point.temporal[0] = ResidualState::Good;
  window.keyframe(1).points.push_back(point);
  window.remove(0);
  CHECK(window.keyframe(1).points[0].temporal[0] == ResidualState::Absent);
  CHECK(window.find(0) == nullptr);
  REQUIRE(window.find(2) != nullptr);
  add(window, 7);
  CHECK(window.newestSlot() == 0);
  CHECK(window.find(7) == &window.keyframe(0));
  CHECK(window.pointCount() == 1);
  window.clear();
  CHECK(window.empty());
}
