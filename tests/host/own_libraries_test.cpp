// SPDX-License-Identifier: BSD-3-Clause
#include <immintrin.h>

#include <catch2/catch.hpp>

#include "host/fixture_plugins.hpp"
#include "host/library.hpp"

using namespace tolman;
using namespace tolman::test;

TEST_CASE("a library that a plugin brings along is one of its files") {
  const auto files = load("brings_library", "brings_library").manifest.program_files;
  REQUIRE(files.size() == 1);  // none of the system
  CHECK(load("brings_library", "brings_library").manifest.program_files == files);
  CHECK(files[0] == fixtureFolder("brings_library") / "libtolman_brought.so");
}

TEST_CASE("other plugins have none") {
  CHECK(load("steady", "steady").manifest.program_files.empty());
}

TEST_CASE("a second library of one name is refused, and the open one stays as it is") {
  const auto first = load("brings_library", "brings_library");
  const host::Refusal refusal = REFUSAL_OF(load("brings_another", "brings_another"));
  CHECK(refusal.id == "plugin/library-conflict");
  CHECK(refusal.message.find("brings_another/libtolman_brought.so, but ") != std::string::npos);
  CHECK(refusal.remedy.find("isolation: process") != std::string::npos);
  CHECK_NOTHROW(load("brings_library", "brings_library"));
}

TEST_CASE("a plugin that was linked with -ffast-math does not change the host's arithmetic") {
  REQUIRE_NOTHROW(load("brings_library", "brings_library"));
  CHECK((_mm_getcsr() & 0x8040U) == 0);
}
