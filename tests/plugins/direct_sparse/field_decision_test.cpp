// SPDX-License-Identifier: BSD-3-Clause
// When the field of disparity errors is switched on and off.
#include <catch2/catch.hpp>

#include "disparity_field.hpp"

using namespace tolman::direct_sparse;

TEST_CASE("a field is on after three significant estimates in a row") {
  FieldDecision decision;
  CHECK_FALSE(decision.decide(false, 0.3));
  CHECK_FALSE(decision.decide(false, 0.3));
  CHECK_FALSE(decision.decide(false, 0.09));  // starts again
  CHECK_FALSE(decision.decide(false, 0.3));
  CHECK_FALSE(decision.decide(false, 0.3));
  CHECK(decision.decide(false, 0.3));
}

TEST_CASE("a field that is on stays on while it is not clearly smaller, and reset forgets it") {
  FieldDecision decision;
  for (int i = 0; i < 20; ++i) CHECK(decision.decide(true, 0.07));
  CHECK(decision.decide(true, 0.04));
  CHECK(decision.decide(true, 0.04));
  CHECK_FALSE(decision.decide(true, 0.04));
  for (int i = 0; i < 20; ++i) CHECK_FALSE(decision.decide(false, 0.07));
  for (int i = 0; i < 2; ++i) decision.decide(false, 0.2);
  decision.reset();
  CHECK_FALSE(decision.decide(false, 0.2));
}
