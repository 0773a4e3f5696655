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

TEST_CASE("other names are refused, with the nearest that is right") {
  const std::vector<std::pair<std::string, std::string>> cases = {{"MyPlaces", "my_places"},
                                                                  {"my-places", "my_places"},
                                                                  {"2fast", "fast"},
                                                                  {"a__b", "a_b"},
                                                                  {"tail_", "tail"},
                                                                  {"_head", "head"},
                                                                  {"HOG", "hog"},
                                                                  {"../escape", "escape"},
                                                                  {"a b", "a_b"}};
  for (const auto& [name, remedy] : cases) {
    INFO(name);
    const auto objection = objectionTo(name);
    REQUIRE(objection);
    CHECK(objection->ends_with("; try '" + remedy + "'"));
    CHECK_FALSE(objectionTo(remedy));
  }
  CHECK(objectionTo("none")->ends_with("; try 'my_none'"));
  CHECK(objectionTo("")->ends_with("; choose such a name"));
  CHECK(objectionTo("1234")->ends_with("; choose such a name"));
  CHECK(objectionTo(std::string(41, 'a')));
  CHECK_FALSE(objectionTo(std::string(40, 'a')));
}

TEST_CASE("a name whose files would overwrite others is refused") {
  CHECK(*objectionTo("plugin") ==
        "'plugin' is the name of another file of the repository; try 'my_plugin'");
  CHECK(objectionTo("test_context"));
}

TEST_CASE("roles have their names, and typos a remedy") {
  CHECK(roleNamed("observer").value() == tolman::Role::Observer);
  CHECK(roleNamed("obsever").status().message() ==
        "there is no role 'obsever'; a plugin is one of source, odometry, place, cells, map, "
        "observer; did you mean 'observer'?");
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

TEST_CASE("a folder that cannot be made or written is named, with the reason and the remedy") {
  const tolman::test::TemporaryFolder folder;
  const fs::path templates = folder.path() / "template";
  writeTemplates(templates);
  std::ofstream(folder.path() / "file") << "mine";
  const auto below =
      writeNewPlugin(templates, {tolman::Role::Cells, "c", folder.path() / "file/a/c"});
  REQUIRE_FALSE(below.isOk());
  const std::string text = below.status().message();
  CAPTURE(text);
  CHECK(text.find("cannot be written: " + (folder.path() / "file").string() +
                  " (Not a directory)") != std::string::npos);
  CHECK(text.find("or name another one") != std::string::npos);
  const auto of_kernel = writeNewPlugin(templates, {tolman::Role::Cells, "c", "/proc/c"});
  REQUIRE_FALSE(of_kernel.isOk());
  CHECK(of_kernel.status().message().starts_with(
      "/proc/c: the plugin's folder cannot be written: /proc ("));
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
