// SPDX-License-Identifier: BSD-3-Clause
// A file without a name compared with a block of memory: written, read, partly released, removed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "run_store.hpp"
#include "support/data.hpp"
#include "tolman/context.hpp"

namespace tolman::web_viewer {
namespace {

std::string readBack(const TemporaryFile& file, std::uint64_t offset, std::size_t size) {
  std::string bytes(size, '?');
  file.read(offset, bytes);
  return bytes;
}

/// $TMPDIR is another folder while this lives.
struct OtherTemporaryFolder {
  explicit OtherTemporaryFolder(const std::string& path) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    ::setenv("TMPDIR", path.c_str(), 1);
  }
  ~OtherTemporaryFolder() {
    before_.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before_.c_str(), 1);
  }
  std::string before_;
};

}  // namespace

TEST_CASE("what was written last at a place is read there, whatever was written around it") {
  RandomStream random(17);
  TemporaryFile file;
  std::string memory;
  for (int i = 0; i < 400; ++i) {
    const std::size_t offset = random.below(20'000);
    std::string bytes(1 + random.below(3'000), '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.below(256));
    memory.resize(std::max(memory.size(), offset + bytes.size()));  // gaps are zeros
    std::copy(bytes.begin(), bytes.end(), memory.begin() + static_cast<std::ptrdiff_t>(offset));
    file.write(offset, bytes);
    const std::size_t from = random.below(memory.size());
    const std::size_t size = random.below(memory.size() - from + 1);
    REQUIRE(readBack(file, from, size) == memory.substr(from, size));
  }
}

TEST_CASE("reading beyond the end is an error, not silence") {
  TemporaryFile file;
  file.write(0, std::string("12345678"));
  CHECK(readBack(file, 0, 8) == "12345678");
  CHECK_THROWS_AS(readBack(file, 1, 8), std::system_error);
  CHECK_THROWS_AS(readBack(file, 100, 1), std::system_error);
  CHECK(readBack(file, 100, 0).empty());
}

TEST_CASE("released blocks read as zeros, and their neighbours as before") {
  constexpr std::size_t kBlock = 4096;
  TemporaryFile file;
  file.write(0, std::string(3 * kBlock, 'x'));
  if (!file.release(kBlock, kBlock)) return;  // not on this file system
  CHECK(readBack(file, 0, kBlock) == std::string(kBlock, 'x'));
  CHECK(readBack(file, kBlock, kBlock) == std::string(kBlock, '\0'));
  CHECK(readBack(file, 2 * kBlock, kBlock) == std::string(kBlock, 'x'));
}

TEST_CASE("the file has no name, so that nothing is left when the process dies") {
  const test::TemporaryFolder folder;
  const OtherTemporaryFolder there(folder.path().string());
  TemporaryFile file;
  file.write(0, std::string("abc"));
  CHECK(std::filesystem::is_empty(folder.path()));
  CHECK(readBack(file, 0, 3) == "abc");
}

TEST_CASE("a folder that is not there is named in the error") {
  const OtherTemporaryFolder there("/nowhere-at-all");
  CHECK_THROWS_WITH(TemporaryFile(),
                    "/nowhere-at-all: cannot hold temporary files; set TMPDIR to a folder that "
                    "exists and can be written: No such file or directory");
  const OtherTemporaryFolder none("/proc");
  CHECK_THROWS_WITH(TemporaryFile(), Catch::StartsWith("/proc: cannot hold temporary files; set "));
}

}  // namespace tolman::web_viewer
