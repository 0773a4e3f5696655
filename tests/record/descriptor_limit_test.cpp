// SPDX-License-Identifier: BSD-3-Clause
// Too few file descriptors are named as the cause, and run.json can be written nevertheless.
#include "record/descriptor_limit.hpp"

#include <memory>

#include "record/by_hand.hpp"
#include "record/run_directory.hpp"
#include "record/sqlite.hpp"
#include "support/data.hpp"
#include "support/few_descriptors.hpp"

using namespace tolman;
using namespace tolman::record;
namespace fs = std::filesystem;

namespace {

using test::FewDescriptors;

RunDirectoryOptions at(const fs::path& out) { return {"runs", "run", 1'767'268'800, out}; }

}  // namespace

TEST_CASE("a limit of open files is recognised, also with some left") {
  CHECK_FALSE(areDescriptorsShort(kFilesOfDatabase));
  for (const int left : {0, 3}) {
    const FewDescriptors few(left);
    CHECK(areDescriptorsShort(kFilesOfDatabase));
  }
  const FewDescriptors enough(4);
  CHECK_FALSE(areDescriptorsShort(kFilesOfDatabase));
}

TEST_CASE("a database that cannot be opened for want of descriptors names the limit") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "run.sqlite";
  Status status;
  {
    const FewDescriptors few(0);
    status = guarded("run.sqlite", [&] { (void)openDatabase(file, Access::Create); });
  }
  CHECK(status.message() ==
        "run.sqlite: unable to open database file; allow more open files (`ulimit -n`)");
  status = guarded("run.sqlite", [&] {
    (void)openDatabase(folder.path() / "none" / "run.sqlite", Access::Create);
  });
  CHECK(status.message().find("check path") != std::string::npos);
}

TEST_CASE("files and folders that cannot be opened for want of descriptors name the limit") {
  const test::TemporaryFolder folder;
  Status written;
  Status made;
  {
    const FewDescriptors few(0);
    written = writeAtomically(folder.path() / "a.txt", "text");
    made = RunDirectory::create(at(folder.path() / "run")).status();
  }
  for (const Status& status : {written, made}) {
    CAPTURE(status.message());
    CHECK(status.message().ends_with("; allow more open files (`ulimit -n`)"));
    CHECK(status.message().find("permissions") == std::string::npos);
  }
}

TEST_CASE("run.json is written though no further file can be opened") {
  const test::TemporaryFolder folder;
  const auto run = RunDirectory::create(at(folder.path() / "run"));
  REQUIRE(run.isOk());
  REQUIRE(run.value().writeRunFile({{"name", "a"}}, RunState::Running).isOk());
  Status first;
  Status second;
  {
    const FewDescriptors few(0);
    first = run.value().writeRunFile({{"name", "a"}}, RunState::Failed);
    second = run.value().writeRunFile({{"name", "b"}}, RunState::Failed);
  }
  CHECK(first.isOk());
  CHECK(second.isOk());
  const auto json = RunDirectory::readRunFile(run.value().path());
  CHECK(json["status"] == "failed");
  CHECK(json["name"] == "b");
}
