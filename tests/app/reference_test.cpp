// SPDX-License-Identifier: BSD-3-Clause
// docs/reference is generated: fails if a declaration changed and the pages did not.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "record/schema.hpp"
#include "support/paths.hpp"

TEST_CASE("docs/reference/records.md is up to date (scripts/generate-reference)") {
  std::ifstream file(tolman::test::inSource("docs/reference/records.md"));
  std::ostringstream text;
  text << file.rdbuf();
  CHECK(text.str() == tolman::record::recordsMarkdown());
}
