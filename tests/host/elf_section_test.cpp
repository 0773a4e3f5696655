// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <sstream>

#include "host/fixture_plugins.hpp"
#include "host/manifest.hpp"
#include "support/data.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::host;
namespace fs = std::filesystem;

namespace {

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

fs::path write(const test::TemporaryFolder& folder, const std::string& bytes) {
  const fs::path file = folder.path() / "x.so";
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::string read(const fs::path& file) { return readElfSection(file, "tolman_manifest"); }

}  // namespace

TEST_CASE("the manifest section of a plugin is read without opening it") {
  CHECK(read(test::fixtureFile("steady")).find("\"id\":\"steady\"") != std::string::npos);
}

TEST_CASE("files that are no plugin are refused by name") {
  const test::TemporaryFolder folder;
  CHECK(REFUSAL_OF(read(folder.path() / "absent.so")).id == "plugin/unreadable");
  CHECK(REFUSAL_OF(read(folder.path())).id == "plugin/unreadable");
  CHECK(REFUSAL_OF(read(write(folder, ""))).id == "plugin/not-elf");
  CHECK(REFUSAL_OF(read(write(folder, "#!/bin/sh\necho hello\n"))).id == "plugin/not-elf");
  CHECK(REFUSAL_OF(read(test::fixtureFile("no_manifest"))).id == "plugin/no-manifest");
}

TEST_CASE("a library cut off anywhere is refused as truncated") {
  const test::TemporaryFolder folder;
  const std::string whole = contents(test::fixtureFile("steady"));
  for (const double share : {0.01, 0.3, 0.6, 0.99}) {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    CHECK(REFUSAL_OF(read(write(folder, whole.substr(0, length)))).id == "plugin/truncated");
  }
  CHECK(REFUSAL_OF(read(write(folder, whole.substr(0, 20)))).id == "plugin/truncated");
}

TEST_CASE("a 32-bit or foreign library is refused as the wrong machine") {
  const test::TemporaryFolder folder;
  std::string bytes = contents(test::fixtureFile("steady"));
  bytes[18] = 40;  // e_machine: ARM
  CHECK(REFUSAL_OF(read(write(folder, bytes))).id == "plugin/wrong-machine");
}

TEST_CASE("damaged bytes never crash the reader") {
  const test::TemporaryFolder folder;
  const std::string whole = contents(test::fixtureFile("steady"));
  RandomStream random(7);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    for (int k = 0; k < 8; ++k) {
      // Half of the hits go where the structure is: header and section table.
      const std::size_t table = whole.size() - 64 * 40;
      const std::size_t where = k % 2 == 0 ? random.below(64) : table + random.below(64 * 40);
      damaged[where] = static_cast<char>(random.bits());
    }
    try {  // any answer is right, as long as it comes
      (void)readManifests(write(folder, damaged));
    } catch (const Refusal&) {
    }
  }
  SUCCEED("300 damaged files were answered");
}
