// SPDX-License-Identifier: BSD-3-Clause
// What records say of themselves.
#include "tolman/records.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace tolman;

TEST_CASE("a loop can be given up, what was driven cannot") {
  Link link;
  CHECK(link.isBelieved());
  link.weight = 0.01;
  CHECK(link.isBelieved());
  link.kind = LinkKind::Loop;
  CHECK_FALSE(link.isBelieved());
  link.weight = 0.1;
  CHECK(link.isBelieved());
  link.weight = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(link.isBelieved());
}
