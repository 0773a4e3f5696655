// SPDX-License-Identifier: BSD-3-Clause
// When an experience is created, kept, or recognised.
#include "experience_memory.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::pose_cells;

namespace {
const ActivityVolume kVolume(30, 36);
}

TEST_CASE("a new template makes an experience, the same one nearby keeps it") {
  ExperienceMemory memory(1);
  CHECK(memory.current() == -1);
  CHECK(memory.decide(kVolume, {10, 10, 0}, 0, 0) == Action::CreateExperience);
  CHECK(memory.decide(kVolume, {10.5, 10, 0}, 0, 0) == Action::Stay);
  CHECK(memory.decide(kVolume, {11, 10, 0}, 0, 1) == Action::CreateExperience);
  CHECK(memory.current() == 1);
}

TEST_CASE("the old template at its old place is a loop, elsewhere a new experience") {
  ExperienceMemory memory(1);
  memory.decide(kVolume, {10, 10, 0}, 0, 0);
  memory.decide(kVolume, {15, 10, 0}, 0, 1);
  CHECK(memory.decide(kVolume, {10.4, 10.2, 35.9}, 0, 0) == Action::CloseLoop);
  CHECK(memory.current() == 0);
  CHECK(memory.decide(kVolume, {20, 20, 0}, 0, 0) == Action::CreateExperience);
  // Two experiences have template 0 now; the nearer one is found again.
  memory.decide(kVolume, {25, 25, 0}, 0, 2);
  CHECK(memory.decide(kVolume, {20.1, 20, 0}, 0, 0) == Action::CloseLoop);
  CHECK(memory.current() == 2);
}

TEST_CASE("the turn of one view does not leak into the next (defect 6)") {
  // 3 headings off by the view's own turn: the same place. Without a turn: another.
  ExperienceMemory memory(1);
  memory.decide(kVolume, {10, 10, 0}, 0, 0);
  memory.decide(kVolume, {15, 10, 0}, 0, 1);
  CHECK(memory.decide(kVolume, {10, 10, 3}, 3, 0) == Action::CloseLoop);
  CHECK(memory.decide(kVolume, {15, 10, 3}, 0, 1) == Action::CreateExperience);
}
