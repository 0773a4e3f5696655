// SPDX-License-Identifier: BSD-3-Clause
// A file for data outside of memory: written data are read back, no file remains, and a missing
// folder is an error with its reason. For a full disk see landmark_store_test.
#include "scratch_file.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <utility>
#include <vector>

#include "support/data.hpp"
#include "support/environment.hpp"

using tolman::ScratchFile;
using tolman::Status;

namespace {

std::vector<std::byte> pattern(std::size_t size, unsigned seed) {
  std::vector<std::byte> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>((i * 31 + seed) % 251);
  return bytes;
}

}  // namespace

TEST_CASE("what a scratch file was given it gives back, in any order, also after a move") {
  ScratchFile file;
  REQUIRE(file.write(5000, pattern(3000, 1)).isOk());
  REQUIRE(file.write(0, pattern(5000, 2)).isOk());
  REQUIRE(file.write(100, pattern(50, 3)).isOk());
  const ScratchFile moved = std::move(file);
  std::vector<std::byte> read(3000);
  REQUIRE(moved.read(5000, read).isOk());
  CHECK(read == pattern(3000, 1));
  read.resize(50);
  REQUIRE(moved.read(100, read).isOk());
  CHECK(read == pattern(50, 3));
}

TEST_CASE("a scratch file leaves no name in its folder") {
  const tolman::test::TemporaryFolder folder;
  const tolman::test::Environment set("TMPDIR", folder.path().string());
  ScratchFile file;
  REQUIRE(file.write(0, pattern(10, 1)).isOk());
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("reading behind the end of a scratch file, or before it exists, is an error") {
  ScratchFile file;
  std::vector<std::byte> read(20);
  CHECK_FALSE(file.read(0, read).isOk());
  REQUIRE(file.write(0, pattern(10, 1)).isOk());
  CHECK(file.read(0, read).message() ==
        "it is too short; does the folder for temporary files (TMPDIR) exist, and is it full?");
}

TEST_CASE("a folder for temporary files that does not exist is told") {
  const tolman::test::Environment set("TMPDIR", "/nowhere/at/all");
  ScratchFile file;
  CHECK(file.write(0, pattern(10, 1)).message() ==
        "No such file or directory; does the folder for temporary files (TMPDIR) exist, and is it "
        "full?");
}
