// SPDX-License-Identifier: BSD-3-Clause
// Commands and files of a page, in order; everything else is left out.
#include "author/markdown_script.hpp"

#include <catch2/catch.hpp>

using tolman::test::scriptOf;

TEST_CASE("commands are run, announced files are written, the rest is left out") {
  const std::string page =
      "# Page\n\nFirst:\n\n```sh\nmkdir a\ncd a\n```\n\nThe greeting, `hello.txt`:\n\n"
      "```text\nhello $USER\n```\n\nIt prints\n\n```text\nnothing\n```\n";
  CHECK(scriptOf(page) ==
        "set -x\nmkdir a\ncd a\n{ set +x; } 2>/dev/null\n"
        "cat >hello.txt <<'END OF FILE'\nhello $USER\nEND OF FILE\n");
}

TEST_CASE("an announcement counts for the next block only") {
  CHECK(scriptOf("`a`:\n\n```text\n1\n```\n\n```text\n2\n```\n") ==
        "cat >a <<'END OF FILE'\n1\nEND OF FILE\n");
  CHECK(scriptOf("`a`:\nbut see below\n\n```text\n1\n```\n").empty());
}
