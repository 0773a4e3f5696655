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

}  // namespace tolman::record
