// SPDX-License-Identifier: BSD-3-Clause
#include "record/output_places.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "record/run_directory.hpp"
#include "support/data.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "before";
}

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Restores the working directory.
struct Inside {
  explicit Inside(const fs::path& folder) { fs::current_path(folder); }
  ~Inside() { fs::current_path(before); }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  fs::path before = fs::current_path();
};

}  // namespace

TEST_CASE("one file has one path, also before it exists") {
  const test::TemporaryFolder scratch;
  const fs::path folder = fs::canonical(scratch.path());
  fs::create_directory_symlink(folder, folder / "link");
  const Inside inside(folder);
  for (const char* name : {"f.svg", "./f.svg", "link/f.svg", "none/../f.svg", "./link/./f.svg"}) {
    CHECK(truePath(name) == folder / "f.svg");
  }
  CHECK(truePath(folder / "f.svg") == folder / "f.svg");
  CHECK(truePath("run/") == folder / "run");
  CHECK(truePath(".") == folder);
}

TEST_CASE("if one file cannot be written, none is") {
  const test::TemporaryFolder folder;
  const fs::path first = folder.path() / "a.txt";
  put(first);
  fs::create_directory(folder.path() / "b.txt");
  const Status is_folder =
      writeTogether({{first, "new"}, {folder.path() / "b.txt", "new"}}, "--out");
  CHECK(is_folder.message() ==
        (folder.path() / "b.txt").string() +
            ": is a folder, and a file is to be written there; remove it, or "
            "choose another --out");
  CHECK(contentOf(first) == "before");
  const Status no_folder =
      writeTogether({{first, "new"}, {folder.path() / "none/b.txt", "new"}}, "--out");
  CHECK(no_folder.message().find("its folder cannot be opened") != std::string::npos);
  CHECK(contentOf(first) == "before");
  CHECK(writeTogether({{first, "new"}, {folder.path() / "c.txt", "new"}}, "--out").isOk());
  CHECK(contentOf(first) == "new");
}

TEST_CASE("the folders of a run are its own, at any depth and through links") {
  const test::TemporaryFolder scratch;
  const fs::path folder = fs::canonical(scratch.path());
  put(folder / "run/run.sqlite");
  put(folder / "run/mine/x.svg");
  put(folder / "other/run.sqlite");
  fs::create_directory(folder / "run/state");
  fs::create_directory_symlink(folder / "run/state", folder / "link");
  CHECK(runAround(folder / "run/state/deep/x") == folder / "run");
  CHECK_FALSE(runAround(folder / "run"));
  CHECK_FALSE(runAround(folder / "other"));
  for (const char* place :
       {"run/state", "run/figures/x.svg", "run/artefacts/a/b", "link", "link/x"}) {
    CAPTURE(place);
    CHECK_FALSE(refuseRunPlaces(folder / place, "--out").isOk());
    CHECK_FALSE(refuseRunPlaces(folder / place, "--out", folder / "run").isOk());
  }
  for (const char* place : {"run", "state/x", "figures"}) {
    CAPTURE(place);
    CHECK(refuseRunPlaces(folder / place, "--out").isOk());
  }
  for (const char* place : {"run/mine/x.svg", "run/x.svg", "run/new/deep"}) {
    CAPTURE(place);
    CHECK(refuseRunPlaces(folder / place, "--out", folder / "run").isOk());
    const std::string expected = (folder / place).string() + ": lies in the directory of the run " +
                                 (folder / "run").string() +
                                 ", whose files belong to that run alone; choose another --out";
    CHECK(refuseRunPlaces(folder / place, "--out").message() == expected);
    CHECK(refuseRunPlaces(folder / place, "--out", folder / "other").message() == expected);
  }
}

TEST_CASE("a folder with no more than an empty log is no run around its files") {
  const test::TemporaryFolder scratch;
  std::ofstream(scratch.path() / "log.txt").flush();  // as `tolman run --out r > log.txt` makes it
  CHECK_FALSE(runAround(scratch.path() / "r"));
  CHECK(refuseRunPlaces(scratch.path() / "r", "--out").isOk());
}

TEST_CASE("no new run in the folders of another") {
  const test::TemporaryFolder folder;
  const fs::path other = folder.path() / "other";
  put(other / "run.sqlite");
  CHECK_FALSE(RunDirectory::mayTake(other / "state", false).isOk());
  RunDirectoryOptions options;
  options.out = other / "figures/new";
  CHECK_FALSE(RunDirectory::create(options).isOk());
  CHECK_FALSE(fs::exists(other / "figures"));
  options.out = other / "new";
  CHECK_FALSE(RunDirectory::create(options).isOk());
  CHECK_FALSE(fs::exists(other / "new"));
  const Inside inside(other);  // without --out a run goes to runs/ here
  CHECK_FALSE(RunDirectory::create({}).isOk());
  CHECK_FALSE(fs::exists(other / "runs"));
}

}  // namespace tolman::record
