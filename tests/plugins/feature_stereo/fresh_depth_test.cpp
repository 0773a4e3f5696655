// SPDX-License-Identifier: BSD-3-Clause
// Depth images that repeat, or have one value.
#include <catch2/catch.hpp>
#include <limits>

#include "stereo_matching.hpp"

using namespace tolman;
using feature_stereo::FreshDepth;
using Kind = feature_stereo::FreshDepth::Kind;

namespace {

NamedArray depthOf(const std::vector<float>& values) {
  return {"depth", {1, static_cast<int>(values.size())}, values};
}

}  // namespace

TEST_CASE("an image that repeats the one before is told, again and again") {
  FreshDepth fresh;
  const NamedArray one = depthOf({1, 2, 0});
  const NamedArray other = depthOf({1, 2.5F, 0});
  CHECK(fresh.judge(&one) == Kind::Fresh);
  CHECK(fresh.judge(&one) == Kind::Repeated);
  CHECK(fresh.judge(&one) == Kind::Repeated);
  CHECK(fresh.judge(&other) == Kind::Fresh);
  CHECK(fresh.judge(&one) == Kind::Fresh);
  CHECK(fresh.judge(nullptr) == Kind::Fresh);
}

TEST_CASE("one value everywhere is no measurement, and no value is none") {
  FreshDepth fresh;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const NamedArray constant = depthOf({0, 2, 2, nan, -1});
  const NamedArray empty = depthOf({0, 0, nan});
  CHECK(fresh.judge(&constant) == Kind::Constant);
  CHECK(fresh.judge(&empty) == Kind::Fresh);
  CHECK(fresh.judge(&empty) == Kind::Fresh);
}
