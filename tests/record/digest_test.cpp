// SPDX-License-Identifier: BSD-3-Clause
// Digests of files, and whether the files of a run are those that it wrote.
#include "record/digest.hpp"

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <set>

#include "record/by_hand.hpp"
#include "record/export.hpp"
#include "record/run_directory.hpp"
#include "record/sample_run.hpp"
#include "record/schema.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

void recordEnded(const std::filesystem::path& folder, std::int64_t frames) {
  auto recorder = Recorder::open(folder).value();
  for (std::int64_t i = 0; i < frames; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->timing(0, "odometry", static_cast<std::int64_t>(getpid()) + frames).isOk());
  REQUIRE(recorder->close().isOk());
}

/// All rows except those that depend on the machine; without those of record.replay.
std::vector<std::string> rowsOf(const std::filesystem::path& folder) {
  const std::set<std::string> machine = {"timing", "event", "run", "exact_pose"};
  std::vector<std::string> rows;
  for (const Table& table : schema()) {
    if (machine.contains(table.name)) continue;
    std::string cells;
    for (const Column& column : table.columns) {
      cells += (cells.empty() ? "quote(\"" : ", quote(\"") + column.name + "\")";
    }
    const auto more = test::queryByHand(
        folder, "SELECT " + cells + " FROM \"" + table.name + "\" ORDER BY rowid");
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::string toolDigest(const std::filesystem::path& file) {
  std::unique_ptr<FILE, int (*)(FILE*)> pipe(
      popen(("sha256sum '" + file.string() + "'").c_str(), "r"), &pclose);
  std::string digits(64, ' ');
  REQUIRE(fread(digits.data(), 1, 64, pipe.get()) == 64);
  return digits;
}

}  // namespace

TEST_CASE("equal runs have equal records, whatever time they took; others have not") {
  const test::TemporaryFolder one;
  const test::TemporaryFolder two;
  const test::TemporaryFolder three;
  recordEnded(one.path(), 5);
  recordEnded(two.path(), 5);
  recordEnded(three.path(), 6);
  CHECK(rowsOf(one.path()) == rowsOf(two.path()));
  CHECK(rowsOf(one.path()) != rowsOf(three.path()));
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
  recordEnded(folder.path(), 3);
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

TEST_CASE("SHA-256 of the test vectors of FIPS 180-4") {
  CHECK(textDigest("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(textDigest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(textDigest(std::string(1'000'000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

namespace {

/// A run that has ended, with all digests.
struct EndedRun {
  test::TemporaryFolder folder;
  EndedRun() {
    recordEnded(folder.path(), 3);
    REQUIRE(exportRun(folder.path(), folder.path()).isOk());
    REQUIRE(writeResultsDigest(folder.path()).isOk());
    write("config.resolved.yaml", "seed: 1\n");
    say("finished");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
  }
  void say(const std::string& status) const {
    nlohmann::json json = {{"status", status}};
    json[kConfigDigest] = fileDigest(folder.path() / "config.resolved.yaml").value();
    if (status != "running") json[kRecordDigest] = fileDigest(folder.path() / "run.sqlite").value();
    write("run.json", json.dump());
  }
  std::string problem() const { return verify(folder.path()).message(); }
};

}  // namespace

TEST_CASE("a run whose files were changed, exchanged or damaged says which") {
  const EndedRun run;
  CHECK(run.problem().empty());
  CHECK(RunReader::open(run.folder.path()).isOk());
  const std::string rest =
      ": is not what the run wrote: changed, damaged or of another run since; "
      "put the file back, or run it again";
  SECTION("rows of the record") {
    test::queryByHand(run.folder.path(), "UPDATE frame SET stamp_ns = 5 WHERE frame = 0");
    CHECK(run.problem() == (run.folder.path() / "run.sqlite").string() + rest);
    CHECK(RunReader::open(run.folder.path()).status().message() == run.problem());
    const auto lock = RunDirectory::reopen(run.folder.path());
    CHECK(RunReader::open(run.folder.path()).isOk());  // a run that goes on changes its record
  }
  SECTION("the configuration; results may be removed, `tolman export` restores them") {
    std::filesystem::remove(run.folder.path() / "odometry.tum");
    run.write("map.g2o", "");
    CHECK(run.problem().empty());
    run.write("config.resolved.yaml", "seed: 2\n");
    CHECK(run.problem() == (run.folder.path() / "config.resolved.yaml").string() + rest);
  }
  SECTION("a log of an earlier moment, which SQLite would read") {
    run.write("run.sqlite-wal", "from a copy that was made during the run");
    CHECK(run.problem() == (run.folder.path() / "run.sqlite-wal").string() + rest);
  }
}

TEST_CASE("the record of a killed run is checked by SQLite; a run that goes on is not") {
  const EndedRun run;
  run.say("running");
  CHECK(run.problem().empty());
  std::fstream file(run.folder.path() / "run.sqlite",
                    std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(3 * 4096);
  file << std::string(8192, 'x');
  file.close();
  CHECK(run.problem().find("run.sqlite: ") != std::string::npos);
  const auto lock = RunDirectory::reopen(run.folder.path());
  CHECK(run.problem().empty());
}
