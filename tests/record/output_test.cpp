// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <fstream>

#include "record/atomic_file.hpp"
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

TEST_CASE("a path is inside a folder through links, too") {
  const test::TemporaryFolder scratch;
  const fs::path folder = fs::canonical(scratch.path());
  fs::create_directories(folder / "run/state");
  fs::create_directory_symlink(folder / "run/state", folder / "link");
  for (const char* place : {"run", "run/state", "run/none/x.svg", "link", "link/x"}) {
    CAPTURE(place);
    CHECK(isInside(folder / place, folder / "run"));
  }
  CHECK_FALSE(isInside(folder / "runs", folder / "run"));
}

TEST_CASE("files are written up to the first that cannot") {
  const test::TemporaryFolder folder;
  put(folder.path() / "a.txt");
  fs::create_directory(folder.path() / "b.txt");
  const Status status = writeOutputs({{folder.path() / "a.txt", "new"},
                                      {folder.path() / "b.txt", "new"},
                                      {folder.path() / "c.txt", "new"}});
  CHECK(status.message() ==
        (folder.path() / "b.txt").string() + ": cannot be replaced (Is a directory)");
  CHECK(contentOf(folder.path() / "a.txt") == "new");
  CHECK_FALSE(fs::exists(folder.path() / "c.txt"));
}

TEST_CASE("a folder with no more than an empty log is no run around its files") {
  const test::TemporaryFolder scratch;
  std::ofstream(scratch.path() / "log.txt").flush();  // as `tolman run --out r > log.txt` makes it
  CHECK(RunDirectory::mayTake(scratch.path() / "r", false).isOk());
}

TEST_CASE("no new run in the folders of another") {
  const test::TemporaryFolder folder;
  const fs::path other = folder.path() / "other";
  put(other / "run.sqlite");
  for (const char* place : {"state", "mine/deep/new"}) {
    CHECK(RunDirectory::mayTake(other / place, false).message() ==
          (other / place).string() + ": lies in the directory of the run " +
              fs::canonical(other).string() +
              ", whose files belong to that run alone; choose another --out");
  }
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
