// SPDX-License-Identifier: BSD-3-Clause
// Digests of result files, and whether equal runs leave equal records.
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

/// All rows except those that depend on the machine.
std::vector<std::string> rowsOf(const std::filesystem::path& folder) {
  const std::set<std::string> machine = {"timing", "event", "run"};
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
  recordRun(one.path(), 5);
  recordRun(two.path(), 5);
  recordRun(three.path(), 6);
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
