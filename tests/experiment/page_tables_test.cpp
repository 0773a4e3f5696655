// SPDX-License-Identifier: BSD-3-Clause
// The tables of the pages equal the results of their sweeps; a different page is reported.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

Finished checkTables(const fs::path& root, const std::string& option = "--tolman") {
  std::vector<std::string> command = {inSource("scripts/check-tables"), "--root", root.string(),
                                      "--tolman", tolmanProgram().string()};
  if (option != "--tolman") command.push_back(option);
  return run(command);
}

}  // namespace

TEST_CASE("the tables of our pages are what their sweeps said") {
  const Finished checked = checkTables(inSource(""));
  INFO(checked.err);
  CHECK(checked.exit_code == 0);
}

TEST_CASE("a table that its sweep did not say is told, and can be renewed") {
  const TemporaryFolder root;
  fs::create_directories(root.path() / "docs/tables");
  std::ofstream(root.path() / "docs/tables/a.csv")
      << "name,part,sequence,alignment,truth_sha256,results_sha256,x\n"
         "p,one,00,se2,t,r,1.5\nq,two,00,se2,t,s,2.5\n";
  const std::string before =
      "Text\n<!-- tolman compare docs/tables/a.csv --columns sequence --cell '{x:.1f} m' -->\n";
  std::ofstream(root.path() / "docs/page.md")
      << before << "| part | 00 |\n|---|---:|\n| one | 1.5 m |\n| two | 2.4 m |\n\nMore\n";
  const Finished wrong = checkTables(root.path());
  CHECK(wrong.exit_code == 1);
  CHECK(contains(wrong.err, "docs/page.md:2: is not what docs/tables/a.csv says"));
  CHECK(checkTables(root.path(), "--write").exit_code == 0);
  CHECK(readText(root.path() / "docs/page.md") ==
        before + "| part | 00 |\n|---|---:|\n| one | 1.5 m |\n| two | 2.5 m |\n\nMore\n");
  CHECK(checkTables(root.path()).exit_code == 0);
  std::ofstream(root.path() / "docs/tables/b.csv") << "name\n";
  CHECK(contains(checkTables(root.path()).err, "docs/tables/b.csv: no page uses it"));
}
