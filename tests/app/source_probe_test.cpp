// SPDX-License-Identifier: BSD-3-Clause
#include "app/source_probe.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "support/data.hpp"

namespace tolman::app {
namespace {

void writeSparse(const std::filesystem::path& file, std::uintmax_t bytes) {
  std::ofstream{file};
  std::filesystem::resize_file(file, bytes);
}

}  // namespace

TEST_CASE("a source has the more time for the first frames the larger the recording is") {
  const test::TemporaryFolder folder;
  const auto bag = folder.path() / "drive.bag";
  CHECK(probeDeadline(bag).count() == 20);  // not there
  writeSparse(bag, 1000);
  CHECK(probeDeadline(bag).count() == 20);
  writeSparse(bag, 2'000'000'000);
  CHECK(probeDeadline(bag).count() == 120);
  std::filesystem::create_directory(folder.path() / "below");
  writeSparse(folder.path() / "below/other.bag", 1'000'000'000);
  writeSparse(folder.path() / "drive_2.bag", 1'000'000'000);
  CHECK(probeDeadline(folder.path()).count() == 170);  // both parts
}

TEST_CASE("a section of a source is what was tried") {
  CHECK(sourceSection("ros_bag", {{"path", "a.bag"}, {"mono", "true"}}) ==
        "source:\n  plugin: ros_bag\n  path: a.bag\n  mono: true\n");
}

}  // namespace tolman::app
