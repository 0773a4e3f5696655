// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "record/by_hand.hpp"
#include "record/data_digest.hpp"
#include "support/data.hpp"

namespace fs = std::filesystem;

namespace tolman::record {
namespace {

std::vector<std::string> namesOf(const std::vector<DataFile>& files) {
  std::vector<std::string> names;
  for (const DataFile& file : files) names.push_back(file.name);
  return names;
}

}  // namespace

TEST_CASE("files are listed by name, relative to the folder that was given") {
  const test::TemporaryFolder folder;
  test::writeFile(folder.path() / "times.txt", "0\n");
  test::writeFile(folder.path() / "image_0/2.png", "b");
  test::writeFile(folder.path() / "image_0/1.png", "a");
  CHECK(namesOf(dataFiles(folder.path())) ==
        std::vector<std::string>{"image_0/1.png", "image_0/2.png", "times.txt"});
  CHECK(namesOf(dataFiles(folder.path() / "times.txt")) == std::vector<std::string>{""});
}

TEST_CASE("runs beside the data are no data, a run that is named gives its record and state") {
  const test::TemporaryFolder folder;
  test::writeFile(folder.path() / "times.txt", "0\n");
  const fs::path run = folder.path() / "runs/kitti";
  for (const char* file : {"run.json", "run.sqlite", "state/map.bin"}) {
    test::writeFile(run / file, "x");
  }
  CHECK(namesOf(dataFiles(folder.path())) == std::vector<std::string>{"times.txt"});
  CHECK(namesOf(dataFiles(run)) == std::vector<std::string>{"run.sqlite", "state/map.bin"});
}

TEST_CASE("a changed, replaced or removed file is found, new ones are no change") {
  const test::TemporaryFolder folder;
  const fs::path image = folder.path() / "1.png";
  test::writeFile(image, "left");
  test::writeFile(folder.path() / "2.png", "right");
  const auto files = dataFiles(folder.path());
  REQUIRE(firstChanged(files).empty());
  test::writeFile(folder.path() / "3.png", "new");
  CHECK(firstChanged(files).empty());
  SECTION("longer") {
    test::writeFile(image, "left and more");
    CHECK(firstChanged(files) == image);
  }
  SECTION("other bytes of the same length") {
    fs::last_write_time(image, fs::last_write_time(image) + std::chrono::seconds(1));
    CHECK(firstChanged(files) == image);
  }
  SECTION("another file of the same name and age") {
    const auto age = fs::last_write_time(image);
    test::writeFile(folder.path() / "4.png", "LEFT");
    fs::last_write_time(folder.path() / "4.png", age);
    fs::rename(folder.path() / "4.png", image);
    CHECK(firstChanged(files) == image);
  }
  SECTION("removed") {
    fs::remove(image);
    CHECK(firstChanged(files) == image);
  }
}

}  // namespace tolman::record
