// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include "host/fixture_plugins.hpp"
#include "host/manifest.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::host;
using tolman::test::fixtureFile;
using tolman::test::fixtureFolder;
namespace fs = std::filesystem;

TEST_CASE("the search path is command line, environment, own tree") {
  const test::TemporaryFolder tree;
  fs::create_directories(tree.path() / "lib/tolman/plugins");
  const auto path = searchPath({"/a"}, "/b::/c", tree.path() / "bin/tolman");
  CHECK(path == std::vector<fs::path>{"/a", "/b", "/c", tree.path() / "lib/tolman/plugins"});
  CHECK(searchPath({}, nullptr, "/nowhere/bin/tolman").empty());
}

TEST_CASE("a plugin is found by id and role; a broken neighbour does not matter") {
  const test::TemporaryFolder folder;
  fs::copy(fixtureFile("steady"), folder.path());
  std::ofstream(folder.path() / "junk.so") << "junk";
  const Catalogue catalogue({folder.path(), "/does/not/exist"});
  CHECK(catalogue.find("steady", Role::Odometry).id == "steady");
  CHECK(catalogue.manifests().size() == 1);
  REQUIRE(catalogue.broken().size() == 1);
  CHECK(catalogue.broken()[0].refusal.id == "plugin/not-elf");
}

TEST_CASE("the search path may name a library file") {
  const Catalogue catalogue({fixtureFile("steady")});
  CHECK(catalogue.find("steady").id == "steady");
}

TEST_CASE("an earlier folder shadows a later one; two in one folder are ambiguous") {
  const test::TemporaryFolder first;
  const test::TemporaryFolder second;
  fs::copy(fixtureFile("steady"), first.path());
  fs::copy(fixtureFile("steady"), second.path());
  const Catalogue shadowed({second.path(), first.path()});
  CHECK(shadowed.find("steady").file.parent_path() == second.path());

  fs::copy(fixtureFile("steady"), first.path() / "copy.so");
  CHECK(REFUSAL_OF(Catalogue({first.path()}).find("steady")).id == "plugin/ambiguous");
  CHECK(REFUSAL_OF(Catalogue({first.path()}).find("steady", Role::Odometry)).id ==
        "plugin/ambiguous");
}

TEST_CASE("a folder named twice, in two spellings or through a link, counts once") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "real");
  fs::copy(fixtureFile("steady"), folder.path() / "real");
  fs::create_directory_symlink(folder.path() / "real", folder.path() / "link");
  const Catalogue catalogue({folder.path() / "link", folder.path() / "real",
                             folder.path() / "real/../real/", folder.path() / "real"});
  CHECK(catalogue.manifests().size() == 1);
  CHECK(catalogue.find("steady", Role::Odometry).id == "steady");
}

TEST_CASE("an unknown plugin is refused with the searched folders and the nearest name") {
  const Catalogue catalogue({fixtureFolder("steady")});
  const Refusal typo = REFUSAL_OF(catalogue.find("stedy", Role::Odometry));
  CHECK(typo.message == "no odometry plugin 'stedy' in " + fixtureFolder("steady").string());
  CHECK(
      typo.remedy ==
      "did you mean 'steady'? `tolman plugins list` shows the plugins found; --plugin-path adds a "
      "folder");
  CHECK(REFUSAL_OF(catalogue.find("steady", Role::Map)).id == "plugin/wrong-role");
  CHECK(REFUSAL_OF(Catalogue({}).find("x")).message ==
        "no plugin 'x' in any folder: the search path is empty");
}

TEST_CASE("a library of the wanted name that is broken is named with its fault") {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "tolman_cells_mine.so") << "junk";
  const Catalogue catalogue({folder.path()});
  const auto refusal = REFUSAL_OF(catalogue.find("mine", Role::Cells));
  CHECK(refusal.id == "plugin/not-found");
  CHECK(refusal.message.find("may be it, but cannot be used: [plugin/not-elf]") !=
        std::string::npos);
}
