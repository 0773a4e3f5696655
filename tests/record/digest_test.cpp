// SPDX-License-Identifier: BSD-3-Clause
// Are two runs the same?
#include "record/digest.hpp"

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <set>

#include "record/by_hand.hpp"
#include "record/export.hpp"
#include "record/sample_run.hpp"
#include "record/schema.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

void recordRun(const std::filesystem::path& folder, std::int64_t frames) {
  auto recorder = Recorder::open(folder).value();
  for (std::int64_t i = 0; i < frames; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->timing(0, "odometry", static_cast<std::int64_t>(getpid()) + frames).isOk());
  REQUIRE(recorder->close().isOk());
}

/// One row at least in every table.
void recordEverything(const std::filesystem::path& folder) {
  auto recorder = Recorder::open(folder).value();
  REQUIRE(recorder->session({0, 0, "one", "made up"}).isOk());
  RunInfo run;
  run.arrays = {{"hd.activity", ArrayKind::Activity, "", "", "", {}}};
  REQUIRE(recorder->begin(run).isOk());
  for (std::int64_t i = 0; i < 3; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  const Frame frame = test::frameAt(3);
  PlaceObservation place;
  place.frame = 3;
  Decision decision;
  decision.frame = 3;
  decision.earlier = {{1, 0, Eigen::Isometry3d::Identity(), Matrix6d::Identity()}};
  Snapshot snapshot;
  snapshot.frame = &frame;
  snapshot.place = &place;
  snapshot.decision = &decision;
  REQUIRE(recorder->snapshot(snapshot).isOk());
  REQUIRE(recorder
              ->graph({1,
                       {test::experienceAt(0, 0, 0), test::experienceAt(1, 1, 1)},
                       {test::linkBetween(0, 0, 1, 1)},
                       {}})
              .isOk());
  REQUIRE(recorder->revisions({{1, {}, Matrix6d::Identity()}}).isOk());
  REQUIRE(recorder->finalPoses({{0, Eigen::Isometry3d::Identity()}}).isOk());
  REQUIRE(recorder->timing(0, "odometry", 5).isOk());
  REQUIRE(recorder->event(0, LogLevel::Info, "host", "hello").isOk());
  REQUIRE(recorder->close().isOk());
}

std::string toolDigest(const std::filesystem::path& file) {
  std::unique_ptr<FILE, int (*)(FILE*)> pipe(
      popen(("sha256sum '" + file.string() + "'").c_str(), "r"), &pclose);
  std::string digits(64, ' ');
  REQUIRE(fread(digits.data(), 1, 64, pipe.get()) == 64);
  return digits;
}

}  // namespace

TEST_CASE("equal runs have equal digests, whatever time they took; others have not") {
  const test::TemporaryFolder one;
  const test::TemporaryFolder two;
  const test::TemporaryFolder three;
  recordRun(one.path(), 5);
  recordRun(two.path(), 5);
  recordRun(three.path(), 6);
  CHECK(databaseDigest(one.path()).value() == databaseDigest(two.path()).value());
  CHECK(databaseDigest(one.path()).value() != databaseDigest(three.path()).value());
}

TEST_CASE("every column counts, but those of tables that only tell of the machine") {
  const test::TemporaryFolder folder;
  recordEverything(folder.path());
  const std::string digest = databaseDigest(folder.path()).value();
  const std::set<std::string> machine = {"timing", "event", "run"};
  for (const Table& table : schema()) {
    if (table.name == "run") continue;  // its version is what opens the file
    for (const Column& column : table.columns) {
      const test::TemporaryFolder changed;
      std::filesystem::copy(folder.path() / "run.sqlite", changed.path() / "run.sqlite");
      const std::string value = column.type == "BLOB"   ? "x'3333'"
                                : column.type == "TEXT" ? "'other'"
                                                        : "777";
      // Foreign keys are off by default, and the file takes what the schema's types allow.
      test::queryByHand(changed.path(),
                        "UPDATE \"" + table.name + "\" SET \"" + column.name + "\" = " + value +
                            " WHERE rowid = (SELECT max(rowid) FROM \"" + table.name + "\")");
      INFO(table.name << "." << column.name);
      CHECK((databaseDigest(changed.path()).value() == digest) == machine.contains(table.name));
    }
  }
}

TEST_CASE("a NULL is not an empty text, and rows do not run into one another") {
  const test::TemporaryFolder one;
  recordEverything(one.path());
  const std::string digest = databaseDigest(one.path()).value();
  test::queryByHand(one.path(), "UPDATE array SET source = 'cel', name = 'lshd.activity'");
  CHECK(databaseDigest(one.path()).value() != digest);  // the same letters, cut elsewhere
}

TEST_CASE("a file's digest is that of sha256sum, around the size of the buffer too") {
  const test::TemporaryFolder folder;
  RandomStream random(65);
  for (const std::size_t size : {0, 1, 64, 65535, 65536, 65537, 200'000}) {
    std::string bytes(size, ' ');
    for (char& byte : bytes) byte = static_cast<char>(random.below(256));
    std::ofstream(folder.path() / "file", std::ios::binary) << bytes;
    CHECK(fileDigest(folder.path() / "file").value() == toolDigest(folder.path() / "file"));
  }
  CHECK(fileDigest(folder.path() / "absent").status().message() ==
        (folder.path() / "absent").string() + ": cannot be read");
}

TEST_CASE("results.sha256 is what sha256sum understands") {
  const test::TemporaryFolder folder;
  recordRun(folder.path(), 3);
  REQUIRE(exportRun(folder.path(), folder.path()).isOk());
  REQUIRE(writeResultsDigest(folder.path()).isOk());
  const std::string check =
      "cd '" + folder.path().string() + "' && sha256sum --quiet -c results.sha256";
  CHECK(std::system(check.c_str()) == 0);
  const std::string lines = test::contentOf(folder.path() / "results.sha256");
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 5);
}

TEST_CASE("results.sha256 names only what there is") {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "map.g2o") << "FIX 0\n";
  std::ofstream(folder.path() / "notes.txt") << "not ours";
  REQUIRE(writeResultsDigest(folder.path()).isOk());
  CHECK(test::contentOf(folder.path() / "results.sha256") ==
        toolDigest(folder.path() / "map.g2o") + "  map.g2o\n");
}
