// SPDX-License-Identifier: BSD-3-Clause
// Names of new plugins, placeholders, and the files that are written.
#include "app/plugin_template.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "support/data.hpp"
#include "tolman/version.hpp"

using namespace tolman::app;
namespace fs = std::filesystem;

namespace {

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A folder of templates with two files, one of them in a folder and named after the plugin.
void writeTemplates(const fs::path& folder) {
  fs::create_directories(folder / "shared");
  fs::create_directories(folder / "cells/tests");
  std::ofstream(folder / "shared/.gitignore.in") << "/build*/\n";
  std::ofstream(folder / "cells/about.md") << "Sums up.\n\nTells more,\nin two lines.\n";
  std::ofstream(folder / "cells/tests/@NAME@_test.cpp.in")
      << "@CLASS@ is @ROLE@ @NAME@; @SUMMARY@ @ABOUT@ me@home @SDK_VERSION@";
  std::ofstream(folder / "cells/notes.txt") << "not a template";
}

}  // namespace

TEST_CASE("names that are identifiers everywhere are accepted") {
  for (const char* name : {"a", "my_places", "v2", "hog_9_bins"}) {
    INFO(name);
    CHECK_FALSE(objectionTo(name));
  }
}

TEST_CASE("other names are refused, and so are those with another meaning") {
  for (const char* name : {"MyPlaces", "my-places", "2fast", "a__b", "tail_", "_head", "HOG",
                           "../escape", "a b", "", "1234"}) {
    INFO(name);
    REQUIRE(objectionTo(name));
    CHECK(objectionTo(name)->ends_with("has 40 of them at most, as my_places"));
  }
  CHECK(objectionTo(std::string(41, 'a')));
  CHECK_FALSE(objectionTo(std::string(40, 'a')));
  CHECK(*objectionTo("plugin") ==
        "'plugin' has another meaning in the repository; try 'my_plugin'");
  CHECK(objectionTo("test_context"));
  CHECK(objectionTo("none"));
}

TEST_CASE("classes are named after the id") {
  CHECK(className("my_places") == "MyPlaces");
  CHECK(className("hog") == "Hog");
  CHECK(className("v2_9x") == "V29x");
}

TEST_CASE("placeholders are filled in, every other @ stays") {
  const std::map<std::string, std::string> values = {{"A", "1"}, {"B", "@A@"}};
  CHECK(fillIn("@A@@A@", values) == "11");
  CHECK(fillIn("x@A@y@B@z", values) == "x1y@A@z");  // what was filled in is not read again
  CHECK(fillIn("me@home, @A@", values) == "me@home, 1");
  CHECK(fillIn("@", values) == "@");
  CHECK(fillIn("@C@", values) == "@C@");
}

TEST_CASE("the files of all roles and of one are written, filled in") {
  const tolman::test::TemporaryFolder folder;
  writeTemplates(folder.path() / "template");
  const fs::path to = folder.path() / "new";
  const auto written =
      writeNewPlugin(folder.path() / "template", {tolman::Role::Cells, "my_cells", to});
  REQUIRE(written.isOk());
  CHECK(written.value() == std::vector<fs::path>{".gitignore", "tests/my_cells_test.cpp"});
  CHECK(
      textOf(to / "tests/my_cells_test.cpp") ==
      "MyCells is cells my_cells; Sums up. Tells more,\nin two lines. me@home " TOLMAN_SDK_VERSION);
}

TEST_CASE("an empty folder may be filled, a file or a full folder may not") {
  const tolman::test::TemporaryFolder folder;
  const fs::path templates = folder.path() / "template";
  writeTemplates(templates);
  fs::create_directories(folder.path() / "empty");
  CHECK(writeNewPlugin(templates, {tolman::Role::Cells, "c", folder.path() / "empty"}).isOk());
  std::ofstream(folder.path() / "file") << "mine";
  const auto refused =
      writeNewPlugin(templates, {tolman::Role::Cells, "c", folder.path() / "file"});
  REQUIRE_FALSE(refused.isOk());
  CHECK(refused.status().message().ends_with("name another one, or remove it"));
  CHECK(textOf(folder.path() / "file") == "mine");
}

TEST_CASE("a folder that cannot be made is named, with the reason and the remedy") {
  const tolman::test::TemporaryFolder folder;
  writeTemplates(folder.path() / "template");
  std::ofstream(folder.path() / "file") << "mine";
  const fs::path below = folder.path() / "file/a/c";
  const auto refused =
      writeNewPlugin(folder.path() / "template", {tolman::Role::Cells, "c", below});
  REQUIRE_FALSE(refused.isOk());
  CHECK(refused.status().message() ==
        below.string() +
            ": the plugin's folder cannot be written (Not a directory); name another one: tolman "
            "plugins new ROLE NAME FOLDER");
}

TEST_CASE("templates that are not installed are missed by name") {
  const tolman::test::TemporaryFolder folder;
  const fs::path program = folder.path() / "bin/tolman";
  CHECK(templateFolder(program).status().message().find("libtolman-sdk-dev") != std::string::npos);
  fs::create_directories(folder.path() / "share/tolman/template/shared");
  CHECK(templateFolder(program).value() == folder.path() / "share/tolman/template");
  CHECK(unusualPrefix(program).value() == folder.path());
  CHECK_FALSE(unusualPrefix("/usr/bin/tolman"));
}
