// SPDX-License-Identifier: BSD-3-Clause
// docs/write-a-plugin.md works: every command of the page is run and every file is written, in the
// order of the page, with an empty home directory.
#include <catch2/catch.hpp>

#include "author/markdown_script.hpp"
#include "author/workshop.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

void replaceOnce(std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  INFO(from);
  REQUIRE(at != std::string::npos);
  REQUIRE(text.find(from, at + 1) == std::string::npos);
  text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("the page's commands, one after the other, make a plugin that runs on the town") {
  const Workshop workshop;
  std::string script = scriptOf(readText(inSource("docs/write-a-plugin.md")));
  replaceOnce(script, "cmake --install build --prefix ~/tolman\nexport",
              "cmake --install " + inBuild("") + " --prefix ~/tolman\nexport");
  const fs::path home = workshop.folder();
  const Finished finished = workshop.shell(
      "unset CMAKE_PREFIX_PATH\nexport HOME=" + home.string() + "\n" + script, "/nonexistent");
  INFO(finished.out << finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(contains(finished.out, "100% tests passed"));
  CHECK(contains(finished.out, "Places by the brightness of vertical strips."));
  CHECK(contains(finished.out, "refused, as it should be"));
  CHECK(contains(finished.err, "did you mean 'tolerance'?"));
  CHECK(fs::exists(home / "plugins/strips/runs/latest/map.svg"));
}
