// SPDX-License-Identifier: BSD-3-Clause
// Run directories and run.json.
#include "record/run_directory.hpp"

#include "record/atomic_file.hpp"
#include "record/by_hand.hpp"
#include "record/recorder.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;
using test::contentOf;
namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kNoon = 1'767'268'800;  // 2026-01-01 12:00:00 UTC

RunDirectoryOptions named(const fs::path& root, const std::string& name) {
  return {root / "runs", name, kNoon, std::nullopt};
}

RunDirectoryOptions at(const fs::path& out) { return {"runs", "run", kNoon, out}; }

std::span<const std::byte> bytesOf(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace

TEST_CASE("runs get a folder with name and time, and `latest` points at the last") {
  const test::TemporaryFolder folder;
  const fs::path root = fs::canonical(folder.path());
  const auto one = RunDirectory::create(named(root, "kitti-paper"));
  REQUIRE(one.isOk());
  CHECK(one.value().path() == root / "runs/kitti-paper-20260101T120000Z");
  CHECK(fs::read_symlink(root / "runs/latest") == "kitti-paper-20260101T120000Z");
  const auto two = RunDirectory::create(named(root, "kitti-paper"));  // in the same second
  CHECK(two.value().path() == root / "runs/kitti-paper-20260101T120000Z-2");
  CHECK(fs::read_symlink(root / "runs/latest") == "kitti-paper-20260101T120000Z-2");
}

TEST_CASE("a run's name cannot lead out of the root") {
  const test::TemporaryFolder folder;
  const auto run = RunDirectory::create(named(fs::canonical(folder.path()), "../../etc/x y"));
  CHECK(run.value().path().filename() == "_._.._etc_x_y-20260101T120000Z");
  CHECK(run.value().path().parent_path() == fs::canonical(folder.path()) / "runs");
}

TEST_CASE("a folder named `latest` is not changed") {
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "runs/latest/precious");
  CHECK(RunDirectory::create(named(folder.path(), "a")).isOk());
  CHECK(fs::is_directory(folder.path() / "runs/latest/precious"));
}

TEST_CASE("--out takes new and empty folders, those of a run only by force, and nothing else") {
  const test::TemporaryFolder folder;
  const fs::path out = fs::canonical(folder.path()) / "deep/out";
  {
    const auto run = RunDirectory::create(at(out));
    REQUIRE(run.isOk());
    REQUIRE(run.value().writeRunFile({{"seed", 1}}, RunState::Finished).isOk());
    std::ofstream(out / "notes.txt") << "mine";
    std::ofstream(out / "run.sqlite-wal") << "of a killed run";
    REQUIRE(ArtefactFolder(out, "map").write("a.txt", bytesOf("a")).isOk());
    std::ofstream(out / "run.npz") << "of the earlier run";
    fs::create_directory(out / "session-0");
    std::ofstream(out / "session-0/trajectory.tum") << "of the earlier run";
  }
  CHECK(RunDirectory::create(at(out)).status().message() ==
        out.string() + ": holds a run; choose another --out, or give --force to replace it");
  CHECK(fs::exists(out / "run.json"));
  RunDirectoryOptions by_force = at(out);
  by_force.replace = true;
  REQUIRE(RunDirectory::create(by_force).isOk());
  CHECK_FALSE(fs::exists(out / "run.json"));
  CHECK_FALSE(fs::exists(out / "run.sqlite-wal"));
  CHECK_FALSE(fs::exists(out / "artefacts"));
  CHECK_FALSE(fs::exists(out / "run.npz"));
  CHECK_FALSE(fs::exists(out / "session-0"));
  CHECK(contentOf(out / "notes.txt") == "mine");  // not ours to remove
  // Now it holds a stranger's file and no run.
  CHECK(RunDirectory::create(at(out)).status().message() ==
        out.string() + ": is not empty and holds no run; choose an empty or new directory");
  CHECK_FALSE(RunDirectory::create(at(out / "notes.txt")).isOk());
}

TEST_CASE("two runs cannot share a folder") {
  const test::TemporaryFolder folder;
  const fs::path out = fs::canonical(folder.path());
  const auto first = RunDirectory::create(at(out));
  REQUIRE(first.isOk());
  CHECK(RunDirectory::create(at(out)).status().message() ==
        out.string() + ": another run is writing here; choose another --out");
}

TEST_CASE("a run was killed if its status is running and no process holds the lock") {
  const test::TemporaryFolder folder;
  CHECK_FALSE(RunDirectory::wasKilled(folder.path()));
  {
    const auto run = RunDirectory::create(at(folder.path())).value();
    REQUIRE(run.writeRunFile({{"seed", 7}}, RunState::Running).isOk());
    CHECK_FALSE(RunDirectory::wasKilled(folder.path()));  // it goes on
  }
  CHECK(RunDirectory::wasKilled(folder.path()));
  std::ofstream(folder.path() / "run.json") << R"({"status": "finished"})";
  CHECK_FALSE(RunDirectory::wasKilled(folder.path()));
  std::ofstream(folder.path() / "run.json") << "[1";
  CHECK_FALSE(RunDirectory::wasKilled(folder.path()));
}

TEST_CASE("run.json carries provenance and status, even with broken text") {
  const test::TemporaryFolder folder;
  const auto run = RunDirectory::create(at(folder.path())).value();
  REQUIRE(run.writeRunFile({{"seed", 7}}, RunState::Running).isOk());
  REQUIRE(
      run.writeRunFile({{"seed", 7}, {"error", "bad \xff byte"}}, RunState::Interrupted).isOk());
  const auto json = nlohmann::json::parse(contentOf(folder.path() / "run.json"));
  CHECK(json["seed"] == 7);
  CHECK(json["status"] == "interrupted");
}
