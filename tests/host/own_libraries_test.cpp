// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "host/fixture_plugins.hpp"
#include "host/library.hpp"

using namespace tolman;
using namespace tolman::test;

TEST_CASE("a library that a plugin brings along is one of its files") {
  const auto loaded = load("brings_library", "brings_library");
  REQUIRE(std::holds_alternative<host::LoadedPlugin>(loaded));
  const auto& files = std::get<host::LoadedPlugin>(loaded).manifest.program_files;
  REQUIRE(files.size() == 1);  // none of the system
  CHECK(files[0] == fixtureFolder("brings_library") / "libtolman_brought.so");
}

TEST_CASE("other plugins, and libraries that are not open, have none") {
  const auto loaded = load("steady", "steady");
  REQUIRE(std::holds_alternative<host::LoadedPlugin>(loaded));
  CHECK(std::get<host::LoadedPlugin>(loaded).manifest.program_files.empty());
  CHECK(host::ownLibraries("/no/such/library.so").empty());
}
