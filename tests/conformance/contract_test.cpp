// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "conformance/test_instance.hpp"

using namespace tolman;
using namespace tolman::conformance;

namespace {

Frame frameAt(std::int64_t frame, std::int64_t stamp_ns) {
  Frame made;
  made.frame = frame;
  made.stamp_ns = stamp_ns;
  return made;
}

}  // namespace

TEST_CASE("dt is the time since the previous frame") {
  const Frame before = frameAt(3, 1'000'000'000);
  const Frame now = frameAt(4, 1'500'000'000);
  Motion motion;
  motion.dt = 0.5;
  CHECK(checkDt(motion, now, &before).isOk());
  CHECK_FALSE(checkDt(motion, now, nullptr).isOk());
  motion.dt = 0.4;
  CHECK(checkDt(motion, now, &before)
            .message()
            .starts_with("dt is 0.400000 s, the stamps say 0.500000"));
}

TEST_CASE("poses are close up to rounding") {
  const Eigen::Isometry3d a = fromPlanar({100, 3, 1});
  CHECK(close(a, fromPlanar({100 + 1e-8, 3, 1})));
  CHECK_FALSE(close(a, fromPlanar({100.01, 3, 1})));
}
