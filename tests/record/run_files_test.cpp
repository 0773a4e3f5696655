// SPDX-License-Identifier: BSD-3-Clause
// Which files of a run directory Tolman removes: its own, and no others.
#include "record/by_hand.hpp"
#include "record/run_directory.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "text";
}

RunDirectoryOptions byForce(const fs::path& out) { return {"runs", "run", 0, out, true}; }

}  // namespace

TEST_CASE("the folders of a run are removed, beside them only files that Tolman writes") {
  const test::TemporaryFolder folder;
  const fs::path out = fs::canonical(folder.path());
  const std::vector<fs::path> own = {"run.json",          "run.sqlite",
                                     "run.nwb",           ".trajectory.tum.partial0",
                                     "figures/map.svg",   "figures/stereo/timing.svg",
                                     "state/map.bin",     "artefacts/map/deep/a.txt",
                                     "session-0/map.g2o", "session-1/trajectory.tum"};
  const std::vector<fs::path> foreign = {"session-0/trajectory.xlsx", "thesis.tex", "notes/a.txt"};
  for (const auto* files : {&own, &foreign}) {
    for (const fs::path& file : *files) put(out / file);
  }
  REQUIRE(RunDirectory::create(byForce(out)).isOk());
  for (const fs::path& file : own) CHECK_FALSE(fs::exists(out / file));
  for (const fs::path& file : foreign) CHECK(fs::exists(out / file));
  for (const char* name : {"figures", "state", "artefacts", "session-1"}) {
    CHECK_FALSE(fs::exists(out / name));
  }
}

TEST_CASE("a run.json of another program does not make a folder a run") {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "run.json") << R"({"scripts": {"run": "node ."}})";
  CHECK_FALSE(RunDirectory::create(byForce(folder.path())).isOk());
  CHECK(fs::exists(folder.path() / "run.json"));
  put(folder.path() / "config.resolved.yaml");  // of a run whose run.json is damaged
  CHECK(RunDirectory::create(byForce(folder.path())).isOk());
}

TEST_CASE("whether a directory would be taken is known without touching it") {
  const test::TemporaryFolder folder;
  const fs::path out = fs::canonical(folder.path());
  CHECK(RunDirectory::mayTake(out / "absent", false).isOk());
  CHECK_FALSE(fs::exists(out / "absent"));
  CHECK(RunDirectory::mayTake(out, false).isOk());
  put(out / "run.sqlite");
  CHECK_FALSE(RunDirectory::mayTake(out, false).isOk());
  CHECK(RunDirectory::mayTake(out, true).isOk());
  CHECK_FALSE(RunDirectory::mayTake(out / "run.sqlite", true).isOk());
  const auto run = RunDirectory::create(byForce(out));
  REQUIRE(run.isOk());
  const std::string busy = RunDirectory::mayTake(out, true).message();
  CHECK(busy.find("another run is writing here") != std::string::npos);
}
