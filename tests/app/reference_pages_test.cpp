// SPDX-License-Identifier: BSD-3-Clause
// docs/reference is what scripts/generate-reference writes, with all plugins of this build.
#include <catch2/catch.hpp>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;

TEST_CASE("the committed reference pages agree with the declarations") {
  const TemporaryFolder folder;
  const std::filesystem::path source = inSource("");
  const Finished made =
      run({"env", "-u", "TOLMAN_PLUGIN_PATH", (source / "scripts/generate-reference").string(),
           folder.path().string(), tolmanProgram().string()});
  INFO(made.err << "out of date: run scripts/generate-reference and commit what it writes");
  REQUIRE(made.exit_code == 0);
  for (const char* page : {"plugins.md", "records.md"}) {
    INFO(page);
    CHECK(readText(folder.path() / page) == readText(source / "docs/reference" / page));
  }
}
