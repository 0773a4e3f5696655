// SPDX-License-Identifier: BSD-3-Clause
// The decision by place and view.
#include <catch2/catch.hpp>
#include <cmath>
#include <experience_memory.hpp>

#include "neuroslam_cells.hpp"

using namespace tolman;
using namespace tolman::neuroslam_cells;

namespace {

double away(const ConjunctivePlace& a, const ConjunctivePlace& b) { return distance(a, b, 36, 36); }
constexpr ConjunctivePlace kHere = {10, 20, 18, 5};

}  // namespace

TEST_CASE("a distance is the short way over all four axes") {
  CHECK(distance({1, 35, 0, 0}, {35, 1, 0, 0}, 36, 36) == Approx(std::hypot(2.0, 2.0)));
  CHECK(distance({0, 0, 1, 0}, {0, 0, 34, 0}, 36, 36) == Approx(3));
  CHECK(distance({0, 0, 0, 35.5}, {0, 0, 0, 0.5}, 36, 36) == Approx(1));
}

TEST_CASE("a view makes an experience, and closes a loop to it when it is near again") {
  ExperienceMemory<ConjunctivePlace> memory(2, away);
  CHECK(memory.decide(kHere, 0) == Action::CreateExperience);
  CHECK(memory.decide(kHere, 0) == Action::Stay);
  CHECK(memory.decide({13, 20, 18, 5}, 1) == Action::CreateExperience);
  CHECK(memory.decide({11, 20, 18, 5}, 0) == Action::CloseLoop);
  CHECK(memory.current() == 0);
}

TEST_CASE("the same view on another storey is another experience") {
  ExperienceMemory<ConjunctivePlace> memory(2, away);
  memory.decide(kHere, 0);
  CHECK(memory.decide({10, 20, 24, 5}, 0) == Action::CreateExperience);
  CHECK(memory.decide({10, 20, 30, 5}, 0) == Action::CreateExperience);
  CHECK(memory.decide({10, 20, 18.5, 5}, 0) == Action::CloseLoop);
  CHECK(memory.current() == 0);
  CHECK(memory.decide({10, 20, 24, 5}, 0) == Action::CloseLoop);
  CHECK(memory.current() == 1);
}

TEST_CASE("the first experience may have no view") {
  ExperienceMemory<ConjunctivePlace> memory(2, away);
  CHECK(memory.createFirst(kHere) == Action::CreateExperience);
  CHECK(memory.current() == 0);
  CHECK(memory.decide(kHere, 3) == Action::CreateExperience);
  CHECK(memory.current() == 1);
}
