// SPDX-License-Identifier: BSD-3-Clause
// Which files of a run directory Tolman removes: its own, and no others.
#include "record/run_files.hpp"

#include "record/artefacts.hpp"
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

TEST_CASE("only files that Tolman writes are removed from the folders of a run") {
  const test::TemporaryFolder folder;
  const fs::path out = fs::canonical(folder.path());
  const std::vector<fs::path> own = {"run.json",
                                     "run.sqlite",
                                     "run.nwb",
                                     "figures/map.svg",
                                     "figures/map.png",
                                     "figures/.map.svg.partial0",
                                     "figures/neurons.json",
                                     "figures/stereo/timing.svg",
                                     "state/session.json",
                                     "state/checkpoint.json",
                                     "state/map.bin",
                                     "state/checkpoint-12-cells.bin",
                                     "session-0/trajectory.tum"};
  const std::vector<fs::path> foreign = {
      "figures/photo.png", "figures/map.svg.bak",   "figures/a/b/map.svg",       "state/notes.txt",
      "state/old/map.bin", "artefacts/map/own.csv", "session-0/trajectory.xlsx", "thesis.tex"};
  for (const auto* files : {&own, &foreign}) {
    for (const fs::path& file : *files) put(out / file);
  }
  const std::string text = "artefact";
  ArtefactFolder artefacts(out, "map");
  for (const char* name : {"deep/a.txt", "two\nlines"}) {
    REQUIRE(artefacts.write(name, std::as_bytes(std::span(text))).isOk());
  }
  const auto run = RunDirectory::create(byForce(out));
  REQUIRE(run.isOk());
  for (const fs::path& file : own) CHECK_FALSE(fs::exists(out / file));
  for (const fs::path& file : foreign) CHECK(fs::exists(out / file));
  CHECK_FALSE(fs::exists(out / "artefacts/map/deep"));
  CHECK_FALSE(fs::exists(out / "artefacts/map/two\nlines"));
  CHECK_FALSE(fs::exists(out / "figures/stereo"));
  auto kept = run.value().kept();
  std::ranges::sort(kept);
  CHECK(kept == std::vector<fs::path>{"artefacts/map/own.csv", "figures/a/b/map.svg",
                                      "figures/map.svg.bak", "figures/photo.png",
                                      "session-0/trajectory.xlsx", "state/notes.txt",
                                      "state/old/map.bin"});
}

TEST_CASE("a run.json of another program does not make a folder a run") {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "run.json") << R"({"scripts": {"run": "node ."}})";
  CHECK_FALSE(RunDirectory::create(byForce(folder.path())).isOk());
  CHECK(fs::exists(folder.path() / "run.json"));
  put(folder.path() / "config.resolved.yaml");  // of a run whose run.json is damaged
  CHECK(RunDirectory::create(byForce(folder.path())).isOk());
}

TEST_CASE("what a run leaves that could not write its first file may be replaced") {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "log.txt").close();
  CHECK(holdsRun(folder.path()));
  CHECK_FALSE(RunDirectory::mayTake(folder.path(), false).isOk());
  CHECK(RunDirectory::mayTake(folder.path(), true).isOk());
  put(folder.path() / "log.txt");  // text of another program
  CHECK_FALSE(holdsRun(folder.path()));
  std::ofstream(folder.path() / "log.txt").close();
  put(folder.path() / "other.txt");
  CHECK_FALSE(holdsRun(folder.path()));
}

TEST_CASE("a folder of a run that is a link is refused before anything is removed") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder elsewhere;
  const fs::path out = fs::canonical(folder.path());
  for (const char* file : {"run.sqlite", "state/map.bin"}) put(out / file);
  put(elsewhere.path() / "map.svg");
  fs::create_directory_symlink(elsewhere.path(), out / "figures");
  CHECK(RunDirectory::create(byForce(out)).status().message() ==
        (out / "figures").string() +
            ": is a link to another folder; remove it, or choose another --out");
  CHECK(fs::exists(out / "state/map.bin"));
  CHECK(fs::exists(elsewhere.path() / "map.svg"));
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
