// SPDX-License-Identifier: BSD-3-Clause
// Files that plugins write into the run directory; other places are refused.
#include "record/atomic_file.hpp"
#include "record/by_hand.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;
using test::contentOf;
namespace fs = std::filesystem;

namespace {

std::span<const std::byte> bytes(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace

TEST_CASE("artefacts go where they belong, replacing older ones") {
  const test::TemporaryFolder folder;
  ArtefactFolder artefacts(folder.path(), "observers.0");
  REQUIRE(artefacts.write("pictures/one.ppm", bytes("old")).isOk());
  REQUIRE(artefacts.write("pictures/one.ppm", bytes("new")).isOk());
  CHECK(contentOf(folder.path() / "artefacts/observers.0/pictures/one.ppm") == "new");
}

TEST_CASE("artefact names cannot leave the folder") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder outside;
  ArtefactFolder artefacts(folder.path(), "map");
  for (const std::string_view name :
       std::initializer_list<std::string_view>{"", "../x", "a/../../x", "/etc/x", "a/", ".",
                                               "a/./b", "..", std::string_view("a\0b", 3)}) {
    INFO(name);
    CHECK(artefacts.write(name, bytes("x")).code() == StatusCode::InvalidParameter);
  }
  CHECK(artefacts.write("../x", bytes("x")).message() ==
        "artefact '../x': the name must be relative, without \"..\"");
  REQUIRE(artefacts.write("fine", bytes("x")).isOk());
  // A link in the place of the file is replaced, not followed.
  std::ofstream(outside.path() / "victim") << "safe";
  fs::create_symlink(outside.path() / "victim", folder.path() / "artefacts/map/victim");
  REQUIRE(artefacts.write("victim", bytes("x")).isOk());
  CHECK(contentOf(outside.path() / "victim") == "safe");
}

TEST_CASE("an instance's name cannot lead out either") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "run");
  for (const char* instance : {"", "..", "../map", "/tmp", "a/../b", "map/"}) {
    INFO(instance);
    ArtefactFolder artefacts(folder.path() / "run", instance);
    CHECK(artefacts.write("x", bytes("x")).code() == StatusCode::InvalidParameter);
  }
  CHECK(fs::is_empty(folder.path() / "run"));
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("unusual but harmless names are accepted") {
  const test::TemporaryFolder folder;
  ArtefactFolder artefacts(folder.path(), "map");
  for (const char* name : {"...", "..x", ".hidden", "a b", "k\xc3\xa4rtchen.svg", "a/b/c/d/e/f"}) {
    INFO(name);
    REQUIRE(artefacts.write(name, bytes(name)).isOk());
    CHECK(contentOf(folder.path() / "artefacts/map" / name) == name);
  }
}

TEST_CASE("any bytes are kept, and none") {
  const test::TemporaryFolder folder;
  ArtefactFolder artefacts(folder.path(), "map");
  const std::string_view binary("\0\xff\r\n\0", 5);
  REQUIRE(artefacts.write("binary", bytes(binary)).isOk());
  CHECK(contentOf(folder.path() / "artefacts/map/binary") == binary);
  REQUIRE(artefacts.write("empty", {}).isOk());
  CHECK(fs::file_size(folder.path() / "artefacts/map/empty") == 0);
}

TEST_CASE("a file in the place of the artefact is named") {
  const test::TemporaryFolder folder;
  ArtefactFolder artefacts(folder.path(), "map");
  REQUIRE(artefacts.write("file", bytes("x")).isOk());
  const std::string under = (folder.path() / "artefacts/map/file/under").string();
  CHECK(artefacts.write("file/under", bytes("x")).message() ==
        under + ": cannot be created; check folder and permissions (Not a directory)");
  REQUIRE(artefacts.write("folder/x", bytes("x")).isOk());
  CHECK_FALSE(artefacts.write("folder", bytes("x")).isOk());
  CHECK(contentOf(folder.path() / "artefacts/map/folder/x") == "x");
  CHECK_FALSE(ArtefactFolder(folder.path() / "absent", "map").write("x", bytes("x")).isOk());
  CHECK_FALSE(fs::exists(folder.path() / "absent"));
}

TEST_CASE("two instances of one plugin have separate folders") {
  const test::TemporaryFolder folder;
  REQUIRE(ArtefactFolder(folder.path(), "left").write("a", bytes("1")).isOk());
  REQUIRE(ArtefactFolder(folder.path(), "right").write("a", bytes("2")).isOk());
  CHECK(contentOf(folder.path() / "artefacts/left/a") == "1");
  CHECK(contentOf(folder.path() / "artefacts/right/a") == "2");
}
