// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "record/by_hand.hpp"
#include "record/digest.hpp"
#include "support/data.hpp"

namespace fs = std::filesystem;

namespace tolman::record {
namespace {

std::string sha256(const std::string& text) {
  Sha256 sha;
  sha.add(text);
  return sha.digest();
}

}  // namespace

TEST_CASE("the digest of a folder is that of the lines that sha256sum writes, in order of names") {
  const test::TemporaryFolder folder;
  test::writeFile(folder.path() / "b/times.txt", "0.1\n");
  test::writeFile(folder.path() / "a.txt", "abc");
  const auto digest = digestData(folder.path());
  REQUIRE(digest.isOk());
  CHECK(digest.value().files == 2);
  CHECK(digest.value().bytes == 7);
  CHECK(digest.value().sha256 ==
        sha256(sha256("abc") + "  a.txt\n" + sha256("0.1\n") + "  b/times.txt\n"));
}

TEST_CASE("runs beside the data are no data, a run that is named gives its record and state") {
  const test::TemporaryFolder folder;
  test::writeFile(folder.path() / "times.txt", "0\n");
  const fs::path run = folder.path() / "runs/kitti";
  for (const char* file : {"run.json", "run.sqlite", "state/map.bin"}) {
    test::writeFile(run / file, "x");
  }
  CHECK(digestData(folder.path()).value().sha256 == sha256(sha256("0\n") + "  times.txt\n"));
  CHECK(digestData(run).value().sha256 ==
        sha256(sha256("x") + "  run.sqlite\n" + sha256("x") + "  state/map.bin\n"));
}

TEST_CASE("a link to another folder is followed, one to a folder around it is not") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder other;
  test::writeFile(folder.path() / "images/1.png", "left");
  test::writeFile(other.path() / "2.png", "right");
  fs::create_directory_symlink(other.path(), folder.path() / "right");
  fs::create_directory_symlink(folder.path(), folder.path() / "images/again");
  fs::create_directory_symlink(".", folder.path() / "images/self");
  fs::create_directory_symlink(".", folder.path() / "images/itself");
  const auto digest = digestData(folder.path());
  REQUIRE(digest.isOk());
  CHECK(digest.value().files == 2);
  CHECK(digest.value().bytes == 9);
}

TEST_CASE("of links to nowhere and named pipes nothing is read") {
  const test::TemporaryFolder folder;
  test::writeFile(folder.path() / "1.png", "left");
  fs::create_symlink(folder.path() / "missing", folder.path() / "2.png");
  REQUIRE(::mkfifo((folder.path() / "3.png").c_str(), 0600) == 0);
  const auto digest = digestData(folder.path());
  REQUIRE(digest.isOk());
  CHECK(digest.value().files == 1);
}

TEST_CASE("contents are read only up to the most bytes, and again only after a change") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "poses.txt";
  test::writeFile(file, "abc");
  const auto first = digestData(file);
  REQUIRE(first.isOk());
  CHECK(first.value().sha256 == sha256(sha256("abc") + "  \n"));
  DataDigest known = first.value();
  known.sha256 = "kept";
  CHECK(digestData(file, known).value().sha256 == "kept");
  CHECK(digestData(file, {}, 2).value().sha256.empty());
  test::writeFile(file, "abcd");
  CHECK(digestData(file, known).value().sha256 == sha256(sha256("abcd") + "  \n"));
}

}  // namespace tolman::record
